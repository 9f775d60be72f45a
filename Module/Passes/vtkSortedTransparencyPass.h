// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSortedTransparencyPass
 * @brief   blending in the order of depth, as far as sorting whole objects or polygons gives it
 *
 * The classic way, as in the survey "Transparency, alpha, compositing" (Real-Time Rendering, 4th edition, 5.5,
 * "Blending order"): what is farther away is drawn first. Needs no memory on the GPU and is right for objects that
 * neither overlap in depth nor pass through each other; elsewhere it is wrong where the order of the centres is not
 * that of the fragments. All orders begin with objects, by the depth of the centres of their bounds along the view; of
 * equal depths, the later one in the renderer's order is in front:
 * - Object (the default): that alone. One drawing of the geometry.
 * - Centroid: the polygons of each object by their centroids, on the CPU (vtkSortedPolygons), only when the view's
 * direction, the data or the transformation has changed. Of actors without a plain vtkPolyDataMapper, and of props that
 * are no actors, the polygons stay as they are, after a warning that names them. Takes the memory of the data once
 * more. Vertex attributes that were added to a mapper are not copied.
 * - Backface: of each object its back faces, then its front faces, by face culling: right for convex, closed objects
 * whose polygons are turned outwards. The geometry goes through the GPU twice.
 *
 * Transmission colours are kept, by both operators. Surfaces may then add more light than they hide: by Over a picture
 * that passes what the window can show ends there at each layer, by Under in the end.
 *
 * Stages, by the operator:
 * 1. Over (the default): back to front, blended into the window.
 * 1. Under: front to back, blended behind what is there already, into a buffer of floats (16 bytes a pixel and sample;
 * with transmission colours into three, one a channel, since blending multiplies with the alpha of its own).
 * 2. Composite: that buffer over the opaque picture.
 * Both give the same picture, but that Over rounds it to the window's bytes at each layer, Under once, where the order
 * among the polygons of an object is given. Where it is not (polygons of an object behind each other, by Object), both
 * draw them as they come: by Over the later one is in front, by Under the earlier.
 */
#ifndef vtkSortedTransparencyPass_h
#define vtkSortedTransparencyPass_h

#include "vtkTranslucencyFrame.h" // for Part
#include "vtkTranslucencyPass.h"
#include "vtkTranslucencyTargets.h" // for Layers

#include <memory> // for Actors
#include <set>    // for names

VTK_ABI_NAMESPACE_BEGIN
class vtkSortedActors;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkSortedTransparencyPass : public vtkTranslucencyPass
{
public:
  static vtkSortedTransparencyPass* New();
  vtkTypeMacro(vtkSortedTransparencyPass, vtkTranslucencyPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OrderType
  {
    Object = 0,
    Centroid = 1,
    Backface = 2
  };

  enum OperatorType
  {
    Over = 0,
    Under = 1
  };

  ///@{
  /**
   * What is sorted: Object (the default), Centroid or Backface, from fast and rough to slow and better. Another value
   * is an error and changes nothing.
   */
  void SetOrder(int order);
  vtkGetMacro(Order, int);
  ///@}

  ///@{
  /**
   * Which way layers are put together: Over (the default), back to front, or Under, front to back. Another value is an
   * error and changes nothing.
   */
  void SetOperator(int which);
  vtkGetMacro(Operator, int);
  ///@}

  std::vector<vtkTranslucencyOption> GetOptions() override;
  bool KeepsTransmissionColors() const override { return true; }

protected:
  vtkSortedTransparencyPass();
  ~vtkSortedTransparencyPass() override;

  bool RenderStages(vtkTranslucencyFrame& frame) override;
  vtkTypeInt64 GetTechniqueBytes() override;
  void ReleaseTechniqueResources(bool contextAlive) override;

  int Order = Object;
  int Operator = Over;

private:
  std::vector<vtkTranslucencyFrame::Part> SortParts(const vtkTranslucencyFrame& frame);
  void WarnOf(const std::set<std::string>& unsorted);

  vtkTranslucencyTargets Layers;
  std::unique_ptr<vtkSortedActors> Actors;
  std::string Unsorted; // the mappers whose polygons can't be sorted, as last warned of

  vtkSortedTransparencyPass(const vtkSortedTransparencyPass&) = delete;
  void operator=(const vtkSortedTransparencyPass&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
