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
 * What a material does to its surfaces (emission, opacity by angle, reflectance) and to the opaque picture behind them
 * (refraction, diffusion, dispersion) every technique draws.
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

  ///@{
  /**
   * Light that the surface gives off, beside what it reflects: red, green and blue, 0 or more, of which a fragment's
   * opacity is the part that is seen, as of all of its colour. Black by default. Other numbers are an error and change
   * nothing.
   */
  void SetEmissionColor(double red, double green, double blue);
  void SetEmissionColor(const double color[3]) { this->SetEmissionColor(color[0], color[1], color[2]); }
  vtkGetVector3Macro(EmissionColor, double);
  ///@}

  ///@{
  /**
   * Illustration: the opacity where the surface is seen from the side, 0 to 1 (1 by default), and the exponent, 0 to
   * 1000, by which it goes over to the prop's own where the surface faces the viewer: with the cosine c of the angle
   * between normal and ray, it is grazing + (own - grazing) c^exponent. 0, the default, leaves the prop's own. With a
   * faint prop that draws outlines; with a grazing opacity of 0, ghosts. Other numbers are an error and change nothing.
   */
  void SetGrazingOpacity(double opacity);
  vtkGetMacro(GrazingOpacity, double);
  void SetGrazingExponent(double exponent);
  vtkGetMacro(GrazingExponent, double);
  ///@}

  ///@{
  /**
   * What the surface reflects of light that meets it head on, 0 to 1: 0.04 for glass of index 1.5, ((n - 1) / (n +
   * 1))^2 for index n. From there it grows to 1 at grazing angles (Schlick 1994, Eq. 15), and what is reflected is
   * neither transmitted nor seen through: the fragment's opacity grows by it. 0, the default, is a surface without
   * reflection. Another number is an error and changes nothing.
   */
  void SetReflectance(double reflectance);
  vtkGetMacro(Reflectance, double);
  ///@}

  ///@{
  /**
   * The index of refraction, 1 to 100: 1 (the default) for none, 1.33 for water, 1.5 for glass. The opaque picture is
   * displaced behind the surface, by Snell's law at its normal, as if it lay in a plane at the pixel's opaque depth, or
   * in the far clipping plane where nothing opaque is. Front faces bend the ray and back faces bend it back, for the
   * distance to that plane: a body takes a closed mesh. Translucent surfaces behind are not displaced. What lies
   * outside the picture is that of its edge, and what is nearer than the surface is not seen in it. Another number is
   * an error and changes nothing.
   */
  void SetIndexOfRefraction(double index);
  vtkGetMacro(IndexOfRefraction, double);
  ///@}

  ///@{
  /**
   * 0 (the default) for surfaces that bound a body, as above; above 0 each surface is a pane that is that thick, in
   * world units, and displaces by that alone. Another number is an error and changes nothing.
   */
  void SetThickness(double thickness);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /**
   * Frosted surfaces: how fast what is behind them blurs with its distance from them, as the standard deviation of a
   * Gaussian in units of that distance; 0 (the default) for none. The variances of several surfaces add up. Only the
   * opaque picture is blurred (McGuire and Mara 2017, "Phenomenological transparency"). Another number, or one above 1,
   * is an error and changes nothing.
   */
  void SetDiffusion(double diffusion);
  vtkGetMacro(Diffusion, double);
  ///@}

  ///@{
  /**
   * Chromatic aberration: the length of the segment over which colours are spread, as a part of the displacement; 0
   * (the default) for none, up to 1. Five samples along it have spectral weights. Where it is above 0 and the index of
   * refraction above 1, the prop's transmission colour counts as its cube, for what bodies absorb (Aizenshtein et al.
   * 2021, "Wavelet transparency", section 3). Another number is an error and changes nothing.
   */
  void SetDispersion(double dispersion);
  vtkGetMacro(Dispersion, double);
  ///@}

  /**
   * What a world unit of it absorbs: the absorbance, -ln(transmittance), of red, green and blue.
   */
  void GetAbsorption(double absorption[3]) VTK_SIZEHINT(3);

  /**
   * Whether it absorbs anything.
   */
  bool Absorbs();

  /**
   * Whether its surfaces give off light.
   */
  bool Emits();

  /**
   * Whether what is opaque is seen differently behind its surfaces.
   */
  bool ChangesBackground();

  /**
   * Whether its surfaces are seen differently from different angles. That takes normals, which VTK's shaders have where
   * a prop is lit; else the prop is drawn as if it faced the viewer, after a warning.
   */
  bool DependsOnAngle();

protected:
  vtkTranslucencyMaterial() = default;
  ~vtkTranslucencyMaterial() override = default;

  double AttenuationColor[3] = { 1, 1, 1 };
  double AttenuationDistance = std::numeric_limits<double>::infinity();
  double EmissionColor[3] = { 0, 0, 0 };
  double GrazingOpacity = 1;
  double GrazingExponent = 0;
  double Reflectance = 0;
  double IndexOfRefraction = 1;
  double Thickness = 0;
  double Diffusion = 0;
  double Dispersion = 0;

private:
  void SetNumber(const char* name, double& member, double value, double least, double most);

  vtkTranslucencyMaterial(const vtkTranslucencyMaterial&) = delete;
  void operator=(const vtkTranslucencyMaterial&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
