// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTranslucencyUnreached
 *
 * The props whose shaders a pass's text does not reach.
 *
 * There are two kinds: props that draw by actors of their own and don't hand their property keys on to them, and props
 * with a shader that has no place for the text. Both are known by what they do: while they are drawn with the pass's
 * key, a program without the text is bound for the framebuffer that is drawn to (vtkTranslucencyShaderWatch). All
 * translucent props are watched in one drawing; if one is met, each is drawn by itself to find which it was, without
 * rasterizing. From then on it is known, and looked at again only when it changes. Where a drawing can't be repeated,
 * since it goes over the opaque picture, all props are looked at before. What a prop says of itself is not asked:
 * vtkSphereHandleRepresentation, vtkDistanceRepresentation3D and vtkLightRepresentation draw translucent geometry and
 * say that they have none.
 */
#ifndef vtkTranslucencyUnreached_h
#define vtkTranslucencyUnreached_h

#include "vtkNew.h"
#include "vtkTranslucencyShaderWatch.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderState;

class vtkTranslucencyUnreached
{
public:
  /// A fragment shader has the text if it has one of these.
  explicit vtkTranslucencyUnreached(const std::vector<std::string>& marks)
    : Marks(marks)
  {
  }

  /// Draws the props of a state with the pass's key.
  using Drawing = std::function<void(const vtkRenderState*)>;

  /// Draws, and notes if a program without the text was met.
  void Watch(vtkOpenGLRenderWindow* window, const std::function<void()>& draw);

  /// Whether one was met since TakeMissed() was last asked the same.
  bool IsMissed() const { return this->Missed; }
  bool TakeMissed();

  /// Looks for the props behind it, among those not known yet. Gives their descriptions, empty if there is none.
  std::string Find(const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw);

  /// Looks again at those known ones that have changed.
  void LookAgain(const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw);

  /// Looks at all props that it has not looked at since they changed, in a drawing of its own. Gives the descriptions
  /// of those found.
  std::string LookAhead(const vtkRenderState* state, vtkOpenGLRenderWindow* window, const Drawing& draw);

  /// Warns of props so described, in the name of a pass, once.
  void Warn(vtkObject* pass, const std::string& descriptions);

  bool Has(vtkProp* prop) const;
  bool HasAny(const vtkRenderState* state) const;

  vtkTranslucencyShaderWatch* GetWatch() { return this->ShaderWatch; }

  /// Forgets the programs, which go with their context.
  void Release() { this->HasText.clear(); }

private:
  struct Known
  {
    vtkWeakPointer<vtkProp> Prop;
    vtkMTimeType Looked;
    bool Reached;
  };

  const Known* FindKnown(vtkProp* prop) const; // null if it is not
  void Note(vtkProp* prop, bool reached);

  bool Test(
    std::vector<vtkProp*> props, const vtkRenderState* like, vtkOpenGLRenderWindow* window, const Drawing& draw);

  bool FindText(vtkShaderProgram* program) const;

  std::vector<std::string> Marks;
  vtkNew<vtkTranslucencyShaderWatch> ShaderWatch;
  std::map<vtkShaderProgram*, bool> HasText;
  std::map<vtkProp*, Known> Props; // at an address there may be another one by now
  bool Missed = false;
  std::set<std::string> Warned; // of these
};
VTK_ABI_NAMESPACE_END

#endif
