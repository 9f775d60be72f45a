// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the preloaded library (Preload.cxx) asks of the drop-in for the program's release of VTK
 * (vtkTranslucencyDropIn.cxx). Both are of one release of this project; they need not be of one compiler, since only
 * pointers go between them.
 */
#ifndef DropInFunctions_h
#define DropInFunctions_h

struct DropInFunctions
{
  /// The release of this project; comes first in every release.
  const char* Release;

  /// The file of the library that the techniques are in, which peel themselves at times.
  const char* ModuleFile;

  /// A new depth peeling pass that draws by the technique.
  void* (*NewPeeling)();

  /// vtkOpenGLRenderer::UpdateGeometry, with peeling on for as long as it takes. Own is VTK's.
  int (*UpdateGeometry)(void* renderer, void* framebuffer, int (*own)(void* renderer, void* framebuffer));

  /// What vtkDefaultPass draws of translucent props, by the technique. False where that is left to VTK's.
  bool (*RenderTranslucent)(const void* state);

  /// What VTK's renderers call as vtkOpenGLRenderer::UpdateGeometry.
  const void* (*GetUpdateGeometry)();
};

/// The name of the function that gives them.
constexpr const char* DropInFunctionsSymbol = "vtkTranslucencyDropInFunctions";

#endif
