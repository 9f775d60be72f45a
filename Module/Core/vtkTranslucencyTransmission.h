// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyTransmission
 *
 * Transmission colours as props have them (vtkTranslucencyPass::TRANSMISSION_COLOR), and the props that let light
 * through without one: what VTK draws by adding it to the picture is as if its colour were white. Each pass has one,
 * which chooses what its technique draws of them.
 */
#ifndef vtkTranslucencyTransmission_h
#define vtkTranslucencyTransmission_h

#include "vtkTranslucencyABINamespace.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderState;
class vtkTranslucencyPass;

class vtkTranslucencyTransmission
{
public:
  static bool HasColor(vtkProp* prop);

  /// vtkTranslucencyPass::SetTransmissionColor and GetTransmissionColor.
  static void SetColor(vtkProp* prop, const std::array<double, 3>& color);
  static bool GetColor(vtkProp* prop, double color[3]);

  /// What is lost of a state's props where VTK draws them: " without transmission colours", or empty.
  static std::string DescribeLost(const vtkRenderState* state);

  /// Whether it is added to the picture, and has no colour of its own.
  static bool IsEmissive(vtkProp* prop);

  /// The translucent props that transmit light, and the class of one whose colour is none.
  struct Count
  {
    int Props = 0;
    int Emissive = 0; // of them: those whose mapper gives them one
    std::string Invalid;
  };
  static Count CountProps(const vtkRenderState* state);

  enum class Kind
  {
    None,
    Mean, ///< of the transmission colours, where the technique keeps one channel
    Colored
  };

  /// What a technique draws of a state's props, on a driver that may lack something. Warns where it is the mean, and of
  /// colours that are none, once.
  Kind Choose(vtkTranslucencyPass* pass, const vtkRenderState* state, const std::string& lacking);

private:
  std::string Mean;    // why the mean was taken, as last warned of,
  std::string Invalid; // and the class of the prop
};
VTK_ABI_NAMESPACE_END

#endif
