#include "vtkFourierOpacityPass.h"

#include "vtkTranslucencyOption.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkFourierOpacityPass);

namespace
{
constexpr int LeastCoefficients = 1;
constexpr int MostCoefficients = 15;
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Coefficients: " << this->Coefficients << "\n";
}

//------------------------------------------------------------------------------
void vtkFourierOpacityPass::SetCoefficients(int coefficients)
{
  if (coefficients < LeastCoefficients || coefficients > MostCoefficients)
  {
    vtkErrorMacro(<< "Coefficients is " << coefficients << ", expected " << LeastCoefficients << " to " << MostCoefficients);
    return;
  }
  if (this->Coefficients != coefficients)
  {
    this->Coefficients = coefficients;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
std::vector<vtkTranslucencyOption> vtkFourierOpacityPass::GetOptions()
{
  std::vector<vtkTranslucencyOption> options{ { "Coefficients", "coefficients", vtkTranslucencyOption::Kind::Integer, 4, LeastCoefficients, MostCoefficients, {},
    "pairs of cosine and sine beside the mean absorbance; more tell nearer fragments apart and take memory and time",
    [this] { return this->GetCoefficients(); }, [this](double value) { this->SetCoefficients(static_cast<int>(value)); } } };
  for (const vtkTranslucencyOption& option : this->Superclass::GetOptions())
  {
    options.push_back(option);
  }
  return options;
}

//------------------------------------------------------------------------------
std::string vtkFourierOpacityPass::GetShaderFolder() const
{
  return "Fourier";
}

//------------------------------------------------------------------------------
vtkTranslucencyFrame::Defines vtkFourierOpacityPass::GetTermDefines() const
{
  return { { "FOURIER_COEFFICIENTS", std::to_string(this->Coefficients) } };
}

//------------------------------------------------------------------------------
int vtkFourierOpacityPass::GetTermCount() const
{
  return 2 * this->Coefficients + 1;
}
