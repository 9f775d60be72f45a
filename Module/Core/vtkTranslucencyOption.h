/**
 * One option of a technique, declared once: the VTK property, the Python keyword, the command's flag and the
 * documentation all follow from the declaration (see vtkTranslucencyPass::GetOptions).
 */
#ifndef vtkTranslucencyOption_h
#define vtkTranslucencyOption_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro

#include <functional>
#include <string>
#include <vector>

struct VTKRENDERINGTRANSLUCENCY_EXPORT vtkTranslucencyOption
{
  enum class Kind
  {
    Integer,
    Real,
    Choice // the value is an index into Choices
  };

  std::string Name;    ///< the VTK property, "NodeCount": SetNodeCount, GetNodeCount
  std::string Keyword; ///< "nodes": nodes=16 in Python, --nodes 16 on the command line ('_' becomes '-')
  Kind Type;
  double Default;
  double Minimum; ///< for a Choice: 0
  double Maximum; ///< for a Choice: the last index
  std::vector<std::string> Choices;
  std::string Help; ///< one line: what it does, its unit, when to change it

  std::function<double()> Get;
  std::function<void(double)> Set;

  /// "1..64", "linked-list or t-buffer": what a value has to be, for messages and help.
  std::string Range() const;

  /// The value as text, as Parse takes it; "other" where it is none of the choices.
  std::string Format(double value) const;

  /// Reads a value; false, with the reason in error, if text is not a value in range.
  bool Parse(const std::string& text, double& value, std::string& error) const;
};

#endif
