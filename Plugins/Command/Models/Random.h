// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Numbers by chance that are the same on every machine and with every release of VTK: the minimal standard generator of
 * Park and Miller, whose integers the C++ standard fixes. The standard's distributions are not fixed so.
 */
#ifndef Random_h
#define Random_h

#include <random>

class Random
{
public:
  explicit Random(int seed)
    : Engine(static_cast<std::minstd_rand0::result_type>(seed))
  {
    this->Engine.discard(3); // the first numbers of neighbouring seeds are alike
  }

  double Next(double low, double high) { return low + (high - low) * (this->Engine() / 2147483647.0); }

private:
  std::minstd_rand0 Engine;
};

#endif
