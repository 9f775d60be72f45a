// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyBuffer
 *
 * A buffer object of OpenGL for shaders to read and write. It belongs to the context in which it was allocated and must
 * be released while that context is current; vtkOpenGLBufferObject knows no storage and no uniform buffers.
 *
 * After a drawing whose shaders store to it, FinishStores comes before anything else here.
 */
#ifndef vtkTranslucencyBuffer_h
#define vtkTranslucencyBuffer_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyBuffer
{
public:
  vtkTranslucencyBuffer() = default;
  vtkTranslucencyBuffer(const vtkTranslucencyBuffer&) = delete;
  vtkTranslucencyBuffer& operator=(const vtkTranslucencyBuffer&) = delete;

  /// Makes the buffer at least this large; what it held is lost if it grows. False if there is no memory for it.
  bool Reserve(vtkTypeInt64 bytes);

  /// The same for a buffer that only Copy writes to and only Download reads.
  bool ReserveForReading(vtkTypeInt64 bytes);

  /// Copies bytes from the start, growing the buffer if needed; false if there is no memory for it.
  bool Upload(const void* data, vtkTypeInt64 bytes);

  /// Sets bytes to 0, from the start or from an offset on.
  void Clear(vtkTypeInt64 bytes, vtkTypeInt64 offset = 0);

  /// Copies bytes from the start of another buffer, without waiting. A driver may move what the application reads into
  /// the host's memory, where the atomic operations of shaders would be slow: what they work on is copied first.
  void Copy(const vtkTranslucencyBuffer& from, vtkTypeInt64 bytes);

  /// Copies bytes back from the start; waits for the commands that write them.
  void Download(void* data, vtkTypeInt64 bytes) const;

  void BindStorage(unsigned int index) const;
  void BindUniform(unsigned int index) const;

  /// Binds a texture that is the buffer to the active texture unit, as GL_TEXTURE_BUFFER. A texel has 1, 3 or 4
  /// unsigned integers.
  void BindTexels(int words);

  /// After a drawing whose shaders store to buffers: from now on other shaders see it, and the application, which may
  /// write there, too.
  static void FinishStores();

  /// Bytes as allocated.
  vtkTypeInt64 GetBytes() const { return this->Bytes; }

  /// Deletes the buffer; where its context is gone it is only forgotten.
  void Release(bool contextAlive = true);

private:
  bool Allocate(vtkTypeInt64 bytes, unsigned int usage);

  unsigned int Handle = 0;
  vtkTypeInt64 Bytes = 0;
  unsigned int Texture = 0;
  int TexelWords = 0; // 0 where the texture is yet to be made the buffer
};
VTK_ABI_NAMESPACE_END

#endif
