// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  vtkTranslucencyResources
 *
 * What a vtkTranslucencyPass keeps from frame to frame: its frames draw with it.
 */
#ifndef vtkTranslucencyResources_h
#define vtkTranslucencyResources_h

#include "vtkTranslucencyBackground.h"
#include "vtkTranslucencyBuffer.h"
#include "vtkTranslucencyCapabilities.h"
#include "vtkTranslucencyLayers.h"
#include "vtkTranslucencyMapperHook.h"
#include "vtkTranslucencyPrograms.h"
#include "vtkTranslucencyPropBounds.h"
#include "vtkTranslucencyResolveStatistics.h"
#include "vtkTranslucencyStatistics.h"
#include "vtkTranslucencyTiles.h"
#include "vtkTranslucencyTransmission.h"
#include "vtkTranslucencyUnreached.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h" // for the weak pointer
#include "vtkWeakPointer.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
struct vtkTranslucencyResources
{
  // The window and the context in it that the OpenGL objects belong to, and what that can do.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  void* Context = nullptr;
  vtkTranslucencyCapabilities Capabilities;

  vtkNew<vtkTranslucencyMapperHook> Mappers;

  // Props that the text does not reach, and what takes their fragments one layer at a time.
  vtkTranslucencyUnreached Unreached{ { "gatherFragment(" } };
  vtkTranslucencyLayers Layers;
  vtkTranslucencyPropBounds Bounds;

  vtkTranslucencyTiles Tiles;
  vtkTranslucencyPrograms Programs;
  vtkTranslucencyResolveStatistics Resolved;
  vtkTranslucencyBuffer SampleColors; // Shaders/Common/SampleColors.glsl

  vtkNew<vtkTranslucencyStatistics> Statistics;
  double GatherTime = -1; // milliseconds, all tiles; negative if not measured
  double ResolveTime = -1;
  int RenderedProps = 0; // by the last drawing

  vtkTranslucencyBackground Background;
  vtkTranslucencyTransmission Transmission;
  std::string MissingForSamples; // the reason for drawing with one sample that was last warned of

  vtkTypeInt64 GetBytes();

  /// Deletes all OpenGL objects, or forgets them, if their context is gone.
  void Release(bool contextAlive);
};
VTK_ABI_NAMESPACE_END

#endif
