#include "vtkOpacityShadowMapPass.h"

#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOpacityShadowMapPass);

namespace
{
constexpr int LeastSlices = 1;
constexpr int MostSlices = 32;
}

//------------------------------------------------------------------------------
void vtkOpacityShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Slices: " << this->Slices << "\n";
}

//------------------------------------------------------------------------------
void vtkOpacityShadowMapPass::SetSlices(int slices)
{
  if (slices < LeastSlices || slices > MostSlices)
  {
    vtkErrorMacro(<< "Slices is " << slices << ", expected " << LeastSlices << " to " << MostSlices);
    return;
  }
  if (this->Slices != slices)
  {
    this->Slices = slices;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkOpacityShadowMapPass::GetOptions()
{
  std::vector<vtkTranslucencyOption> options{ { "Slices", "slices", vtkTranslucencyOption::Kind::Integer, 16, LeastSlices, MostSlices, {},
    "slices of equal depth in which absorbance is summed; more tell nearer fragments apart and take memory and time",
    [this] { return this->GetSlices(); }, [this](double value) { this->SetSlices(static_cast<int>(value)); } } };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
std::string vtkOpacityShadowMapPass::GetShaderFolder() const
{
  return "OpacityShadowMap";
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkOpacityShadowMapPass::GetTermDefines() const
{
  return { { "SLICES", std::to_string(this->Slices) } };
}

//------------------------------------------------------------------------------
int vtkOpacityShadowMapPass::GetTermCount() const
{
  return this->Slices;
}
