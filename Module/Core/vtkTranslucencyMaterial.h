// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyMaterial
 * @brief   what light meets in a prop's translucent surfaces, and between them
 *
 * Beside opacity and transmission colour (vtkTranslucencyPass::SetTransmissionColor), which are a surface's own.
 * Several props may share one:
 *
 * @code
 * vtkNew<vtkTranslucencyMaterial> wine;
 * wine->SetAttenuationColor(0.5, 0.05, 0.1);
 * wine->SetAttenuationDistance(0.02);
 * vtkTranslucencyMaterial::SetMaterial(actor, wine);
 * @endcode
 *
 * Absorption by thickness. A prop whose surfaces enclose a body absorbs between them what its material says: light that
 * has gone the attenuation distance is the attenuation colour times what it was (Beer-Lambert; the quantities are those
 * of glTF's KHR_materials_volume). Front faces, by the order of their points, are where a ray enters the body, back
 * faces where it leaves. A matrix that mirrors the prop turns that round. Along a ray:
 * - Bodies that overlap absorb by the sum of both.
 * - More back faces of a material than front faces: the viewer is inside, and it absorbs from the near plane on. Where
 * an opaque surface hides the back face nothing tells so, and nothing is absorbed.
 * - More front faces than back faces: it absorbs up to the opaque surface behind, or, where there is none, up to the
 * last translucent surface of the pixel. So does a mesh that is not closed or of which faces are culled; points and
 * lines are front faces.
 * - Props that draw by shaders of their own, and volumes, absorb nothing.
 * A picture has up to 31 different attenuations.
 *
 * The surfaces themselves stay what they are: clear glass has an opacity near 0, or a white transmission colour.
 *
 * Techniques that keep all fragments absorb (vtkTranslucencyPass::KeepsFragments), since they know both depths. Others
 * draw the prop without, after an error that says which do.
 */
#ifndef vtkTranslucencyMaterial_h
#define vtkTranslucencyMaterial_h

#include "vtkObject.h"
#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <limits> // for infinity

VTK_ABI_NAMESPACE_BEGIN
class vtkInformationObjectBaseKey;
class vtkProp;

class VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyMaterial : public vtkObject
{
public:
  static vtkTranslucencyMaterial* New();
  vtkTypeMacro(vtkTranslucencyMaterial, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What a prop is made of; null, the default, for nothing beyond its surfaces. Of an assembly, it is the assembly's.
   * It lives in the prop's property keys, MATERIAL.
   */
  static vtkInformationObjectBaseKey* MATERIAL();
  static void SetMaterial(vtkProp* prop, vtkTranslucencyMaterial* material);
  static vtkTranslucencyMaterial* GetMaterial(vtkProp* prop);
  ///@}

  ///@{
  /**
   * What is left of white light after the attenuation distance: red, green and blue, each above 0 and up to 1. White by
   * default, which absorbs nothing. Other numbers are an error and change nothing.
   */
  void SetAttenuationColor(double red, double green, double blue);
  void SetAttenuationColor(const double color[3]) { this->SetAttenuationColor(color[0], color[1], color[2]); }
  vtkGetVector3Macro(AttenuationColor, double);
  ///@}

  ///@{
  /**
   * The distance, in world units, above 0, after which that is left. Infinite by default, which absorbs nothing.
   * Another number is an error and changes nothing.
   */
  void SetAttenuationDistance(double distance);
  vtkGetMacro(AttenuationDistance, double);
  ///@}

  /**
   * What a world unit of it absorbs: the absorbance, -ln(transmittance), of red, green and blue.
   */
  void GetAbsorption(double absorption[3]) VTK_SIZEHINT(3);

  /**
   * Whether it absorbs anything.
   */
  bool Absorbs();

protected:
  vtkTranslucencyMaterial() = default;
  ~vtkTranslucencyMaterial() override = default;

  double AttenuationColor[3] = { 1, 1, 1 };
  double AttenuationDistance = std::numeric_limits<double>::infinity();

private:
  vtkTranslucencyMaterial(const vtkTranslucencyMaterial&) = delete;
  void operator=(const vtkTranslucencyMaterial&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
