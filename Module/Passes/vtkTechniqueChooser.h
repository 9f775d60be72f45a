// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTechniqueChooser
 *
 * Which of several techniques draws the next frame, by budgets and by what the last frames cost. Knows neither OpenGL
 * nor the techniques: it is given their costs in closed form, and measured ones after each frame.
 *
 * Candidates have an order: those within the tolerance, the fastest first; then the others, the best first. The first
 * frame takes the first one that is expected to fit. From then on, before each frame:
 * - Down: if the chosen one took more memory than the budget, or tiles to stay within it, or if the median of its last
 * MedianFrames times is over budget, it is refused. The first other one that is expected to fit takes its place; if
 * none is, the first of those that fit into memory and are hardly slower than the fastest; if nothing fits into memory,
 * the smallest.
 * - Up: an earlier one that was not refused is taken if it is expected to stay below Margin times the budgets.
 * Refusals last until the scene or the view changes. Of the times that were measured, the latest of each candidate are
 * kept, and expected in proportion to the fragments: what was too slow in the frame before is not tried again only
 * because the camera moves.
 *
 * On a still scene the choices become constant: a step up goes to a candidate that was not refused, and each step down
 * refuses one. Between two refusals there are at most as many steps up as candidates, and of refusals there are no more
 * than candidates. A step to one that was refused already, where nothing fits, is the last.
 */
#ifndef vtkTechniqueChooser_h
#define vtkTechniqueChooser_h

#include "vtkTranslucencyABINamespace.h"

#include <deque>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkTechniqueChooser
{
public:
  struct Candidate
  {
    std::string Name;
    double Error;        ///< expected, root mean square of all channels where 1 is the full range
    double RelativeTime; ///< of a frame, to that of the other candidates: while nothing was measured
    double BytesPerFragment;
    double BytesPerPixel;
    double BytesPerSample; ///< of a pixel
    double BytesOfSamples; ///< the same, only where a pixel has several
  };

  /// 0 for any: no budget, or no error that would be as good as none.
  struct Budget
  {
    double Milliseconds = 0; ///< of the stages of a frame
    double Mebibytes = 0;
    double Tolerance = 0; ///< an error that is good enough
  };

  /// What is known of a frame before it is drawn.
  struct View
  {
    double Pixels = 0;
    int Samples = 1;      ///< of a pixel
    bool Changed = false; ///< since the frame before: scene, camera or size
  };

  /// What the chosen technique took for the last frame.
  struct Cost
  {
    double Milliseconds = 0; ///< if there is a budget of time
    double Bytes = 0;
    double Fragments = 0;
    int Tiles = 1;
    bool Steady = true; ///< false if shaders were built, which takes long and only once
  };

  static constexpr int MedianFrames = 5;

  /// A list fills up to half as much memory again as its fragments need while the view moves: less would be left again
  /// at once.
  static constexpr double Margin = 0.7;

  explicit vtkTechniqueChooser(const std::vector<Candidate>& candidates);

  /// Chooses anew; what is known of the fragments stays.
  void SetBudget(const Budget& budget);

  /// Before a frame: the candidate that should draw it.
  int Choose(const View& view);

  /// After it.
  void Observe(const Cost& cost);

  /// The candidate last chosen, -1 before that, and one sentence that says why, with the numbers.
  int GetChosen() const { return this->Chosen; }
  const std::string& GetReason() const { return this->Reason; }

  const Candidate& GetCandidate(int candidate) const { return this->Candidates[candidate]; }

  /// Bytes that the candidate is expected to take for this view.
  double GetBytes(int candidate, const View& view) const;

private:
  enum class Refusal
  {
    None,
    Time,
    Memory
  };

  struct Measured
  {
    double Milliseconds = 0; // 0 while it was not
    double Fragments = 0;
  };

  bool FitsMemory(int candidate, double margin) const;
  bool Promises(int candidate, double margin) const;
  double GetMilliseconds(int candidate) const;
  Refusal GetExcess(std::string& what) const;
  void Start();
  void StepDown(const std::string& excess);
  void StepUp();
  void Take(int candidate);
  std::string Expect(int candidate) const;
  int FindSmallest() const;

  const std::vector<Candidate> Candidates;
  std::vector<int> Order;
  Budget Limits;

  int Chosen = -1;
  std::string Reason;
  View Seen;
  Cost Last;
  double Fragments = -1;    // of the last frame; negative if there was none
  std::deque<double> Times; // the last of the chosen one
  std::vector<Measured> Measurements;
  std::vector<Refusal> Refused;
  bool Settled = false; // until the view changes: nothing better is left
};
VTK_ABI_NAMESPACE_END

#endif
