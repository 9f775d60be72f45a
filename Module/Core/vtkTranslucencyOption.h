// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @struct  vtkTranslucencyOption
 *
 * One option of a technique, declared once: the VTK property, the Python keyword, the command's flag and the
 * documentation all follow from the declaration (see vtkTranslucencyPass::GetOptions).
 */
#ifndef vtkTranslucencyOption_h
#define vtkTranslucencyOption_h

#include "vtkRenderingTranslucencyModule.h" // for the export macro
#include "vtkTranslucencyABINamespace.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;

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

  /// The row of a property MemoryLimit: a bound of the graphics memory for what its owner keeps there.
  static vtkTranslucencyOption NewMemoryLimit(
    const std::string& subject, std::function<double()> get, std::function<void(double)> set);

  /// "1..64", "linked-list or t-buffer": what a value has to be, for messages and help.
  std::string Range() const;

  /// The same for those who set the property: "1 to 64", "linked-list (0) or t-buffer (1)".
  std::string Expected() const;

  /// Whether there is no largest value that would be worth saying.
  bool IsOpen() const;

  /// Whether the option takes the value; NaN is none.
  bool Takes(double value) const;

  /// Whether the option of that name, among an object's own, takes the value. If not, the object gives an error with
  /// the value and what was expected.
  static bool Check(
    vtkObject* object, const std::vector<vtkTranslucencyOption>& options, const char* name, double value);

  /// The setter of a property that is an option: if that takes the value, the property becomes it, and the object is
  /// modified if it was another one; else an error, and nothing changes. Gives whether the property is another one now.
  template <typename Object, typename Value>
  static bool SetProperty(
    Object* object, const std::vector<vtkTranslucencyOption>& options, const char* name, Value& property, Value value)
  {
    const bool changes = Check(object, options, name, static_cast<double>(value)) && property != value;
    if (changes)
    {
      property = value;
      object->Modified();
    }
    return changes;
  }

  /// The same for an integer property that is no technique's option: it may be minimum to maximum.
  template <typename Object, typename Value>
  static bool SetInteger(Object* object, const char* name, Value& property, Value value, double minimum,
    double maximum = std::numeric_limits<double>::infinity())
  {
    return SetProperty(
      object, { { name, "", Kind::Integer, minimum, minimum, maximum, {}, "", {}, {} } }, name, property, value);
  }

  /// The value as text, as Parse takes it; "other" where it is none of the choices.
  std::string Format(double value) const;

  /// Reads a value; false, with the reason in error, if text is not a value in range.
  bool Parse(const std::string& text, double& value, std::string& error) const;
};
VTK_ABI_NAMESPACE_END

#endif
