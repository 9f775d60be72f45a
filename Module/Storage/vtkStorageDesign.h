// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStorageDesign
 *
 * The designs of fragment storage that the study (Module/Study) knows closed forms of, and what shaders of storages
 * count where they are asked to.
 */
#ifndef vtkStorageDesign_h
#define vtkStorageDesign_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGTRANSLUCENCY_EXPORT vtkStorageDesign
{
public:
  enum class Kind
  {
    LinkedList,
    TBuffer,
    RBuffer,
    MBuffer
  };
  static const std::vector<Kind>& GetAll();

  /// linked-list, t-buffer, r-buffer, m-buffer
  static std::string GetName(Kind design);

  /// The design of that name, if there is one: of a storage by its GetName.
  static std::optional<Kind> Find(const std::string& name);

  /// To memory.
  struct Accesses
  {
    std::int64_t Stores = 0;      ///< of fragments
    std::int64_t Reads = 0;       ///< of fragments
    std::int64_t Table = 0;       ///< reads of where a pixel's fragments begin; pixels without any are not counted
    std::int64_t SecondDepth = 0; ///< to the R-buffer's second depth buffer
    std::int64_t FrameBuffer = 0; ///< blending, where fragments come one a pass

    Accesses& operator+=(const Accesses& others)
    {
      this->Stores += others.Stores;
      this->Reads += others.Reads;
      this->Table += others.Table;
      this->SecondDepth += others.SecondDepth;
      this->FrameBuffer += others.FrameBuffer;
      return *this;
    }
    std::int64_t GetTotal() const
    {
      return this->Stores + this->Reads + this->Table + this->SecondDepth + this->FrameBuffer;
    }
  };
};
VTK_ABI_NAMESPACE_END

#endif
