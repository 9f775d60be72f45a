// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyPropBounds
 *
 * The bounds of props in each frame. A mapper brings its pipeline up to date whenever it is asked for them, some
 * microseconds for each prop, so those of an actor are kept while neither it, nor its mapper, nor the mapper's data is
 * another than before. All others are asked anew: props without a mapper, and mappers with more than one input or with
 * composite data, whose parts change by themselves.
 *
 * vtkTranslucencyFingerprint tells more changes, but brings pipelines up to date, too, which is what takes the time
 * here.
 *
 * A pipeline that nobody has updated when the frame begins is noticed one frame later. VTK's renderer does, where it
 * culls or fits the clipping range.
 */
#ifndef vtkTranslucencyPropBounds_h
#define vtkTranslucencyPropBounds_h

#include "vtkTranslucencyABINamespace.h"

#include "vtkType.h"

#include <array>
#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkProp;

class vtkTranslucencyPropBounds
{
public:
  using Bounds = std::array<double, 6>; // least and greatest x, y, z in the world

  /// The bounds of each prop, not initialized (vtkMath::AreBoundsInitialized) where it has none. Forgets other props.
  std::vector<Bounds> Get(const std::vector<vtkProp*>& props);

private:
  struct Origin
  {
    const vtkDataSet* Data = nullptr; // null: always asked anew
    vtkMTimeType Time = 0;            // of the last change to the actor, the mapper or the data
  };

  struct Known
  {
    Origin From;
    Bounds Value;
  };

  static Origin GetOrigin(vtkProp* prop);
  static Bounds Ask(vtkProp* prop);

  std::unordered_map<vtkProp*, Known> Last;
};
VTK_ABI_NAMESPACE_END

#endif
