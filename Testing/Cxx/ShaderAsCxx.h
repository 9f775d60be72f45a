// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What GLSL has and C++ with GLM lacks, for shaders that cmake/WriteShadersAsCxx.cmake has rewritten: the memory that
 * invocations share, as ThreadSanitizer understands it. A thread draws fragment after fragment, as an invocation each.
 *
 * What is modelled:
 * - A word of a buffer is plain memory. Reading and writing it as GLSL's `heads[i]` is plain, too: with another
 *   thread's write that nothing has put in order, it is a race.
 * - An atomic operation is relaxed: it orders nothing but itself, as GLSL has it.
 * - memoryBarrier() is a fence. ThreadSanitizer knows no fences, so the operations beside it take its part. Behind a
 *   barrier, this thread sees what was published to the word of its last atomic operation: the word is loaded once
 *   more, acquiring. Before the next plain access, an atomic operation publishes what came before the barrier: it is a
 *   release. A fence orders more than that. So a race that is reported may be none where atomic operations on several
 *   words come before a barrier, or plain accesses behind it; none is missed, and the shaders have no such places.
 * - An interlock is a mutex a pixel: both of its ends are barriers.
 *
 * Processors that order more than the model promises hide nothing from it: a race is what no rule has put in order,
 * whether or not it did harm. What it can't tell is whether a GPU's compiler keeps to GLSL's rules.
 */
#ifndef ShaderAsCxx_h
#define ShaderAsCxx_h

#define GLM_FORCE_SWIZZLE // as functions
#include <glm/glm.hpp>

#include "ConcurrentShader.h"

#include <cstddef>
#include <map>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace glsl
{
using glm::uint;

/// What the thread's invocation has done last, as far as a barrier goes.
struct Invocation
{
  const uint* Operated = nullptr; // the word of the last atomic operation
  bool Fenced = false;            // there was a barrier, and no plain access since then
  bool Second = false;            // the next barrier is a critical section's second one
  unsigned int Operations = 0;
};

inline Invocation& ThisInvocation()
{
  thread_local Invocation invocation;
  return invocation;
}

/// A word of a buffer that is read and written where it lies.
class Word
{
public:
  explicit Word(uint& memory)
    : Memory(memory)
  {
  }

  operator uint() const
  {
    ThisInvocation().Fenced = false;
    return this->Memory;
  }

  Word& operator=(uint value)
  {
    ThisInvocation().Fenced = false;
    this->Memory = value;
    return *this;
  }

  uint& GetMemory() const { return this->Memory; }

private:
  uint& Memory;
};

/// A storage block's array.
template <class T>
class Words
{
public:
  void Allocate(std::size_t length) { this->Memory.assign(length, T(0u)); }
  int length() const { return static_cast<int>(this->Memory.size()); }

  decltype(auto) operator[](uint index)
  {
    if constexpr (std::is_same_v<T, uint>)
    {
      return Word(this->Memory.at(index));
    }
    else
    {
      ThisInvocation().Fenced = false;
      return (this->Memory.at(index));
    }
  }

private:
  std::vector<T> Memory;
};

template <class T, class... Members>
T construct(Members... members)
{
  return T{ members... };
}

/// How an operation on the word is ordered, which is now the last one. Now and then another thread goes first: on few
/// processors, too, operations of several threads are mixed.
inline int OrderOf(const Word& word)
{
  constexpr unsigned int OperationsOfATurn = 7;
  Invocation& invocation = ThisInvocation();
  if (++invocation.Operations % OperationsOfATurn == 0)
  {
    std::this_thread::yield();
  }
  invocation.Operated = &word.GetMemory();
  return invocation.Fenced ? __ATOMIC_RELEASE : __ATOMIC_RELAXED;
}

inline uint atomicAdd(const Word& word, uint data)
{
  const int order = OrderOf(word);
  if (PresentFault == Fault::PlainAdd)
  {
    uint& memory = word.GetMemory();
    const uint before = memory;
    std::this_thread::yield();
    memory = before + data;
    return before;
  }
  return order == __ATOMIC_RELEASE ? __atomic_fetch_add(&word.GetMemory(), data, __ATOMIC_RELEASE)
                                   : __atomic_fetch_add(&word.GetMemory(), data, __ATOMIC_RELAXED);
}

inline uint atomicExchange(const Word& word, uint data)
{
  const int order = OrderOf(word);
  if (PresentFault == Fault::SplitExchange)
  {
    const uint before = __atomic_load_n(&word.GetMemory(), __ATOMIC_RELAXED);
    std::this_thread::yield();
    __atomic_store_n(&word.GetMemory(), data, __ATOMIC_RELAXED);
    return before;
  }
  return order == __ATOMIC_RELEASE ? __atomic_exchange_n(&word.GetMemory(), data, __ATOMIC_RELEASE)
                                   : __atomic_exchange_n(&word.GetMemory(), data, __ATOMIC_RELAXED);
}

inline uint atomicCompSwap(const Word& word, uint compare, uint data)
{
  const int order = OrderOf(word);
  uint found = compare;
  if (PresentFault == Fault::PlainCompSwap)
  {
    uint& memory = word.GetMemory();
    found = memory;
    std::this_thread::yield();
    if (found == compare)
    {
      memory = data;
    }
    return found;
  }
  const bool swapped = order == __ATOMIC_RELEASE
    ? __atomic_compare_exchange_n(&word.GetMemory(), &found, data, false, __ATOMIC_RELEASE, __ATOMIC_RELAXED)
    : __atomic_compare_exchange_n(&word.GetMemory(), &found, data, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
  if (!swapped)
  {
    std::this_thread::yield(); // to who has what this one waits for
  }
  return found;
}

inline void memoryBarrier()
{
  Invocation& invocation = ThisInvocation();
  const Fault missing = invocation.Second ? Fault::NoSecondBarrier : Fault::NoFirstBarrier;
  invocation.Second = !invocation.Second;
  if (PresentFault == missing)
  {
    return;
  }
  if (invocation.Operated)
  {
    __atomic_load_n(invocation.Operated, __ATOMIC_ACQUIRE);
  }
  invocation.Fenced = true;
}
}

namespace
{
using namespace glm;
using namespace glsl;

// The invocation's own.
thread_local vec4 gl_FragCoord;
thread_local int gl_SampleMaskIn[1];
thread_local bool gl_HelperInvocation;

std::map<std::pair<int, int>, std::mutex> interlocks; // one a pixel, made before threads begin

std::mutex& OwnInterlock()
{
  return interlocks.at({ static_cast<int>(gl_FragCoord.x), static_cast<int>(gl_FragCoord.y) });
}

void beginInvocationInterlockARB()
{
  OwnInterlock().lock();
}

void endInvocationInterlockARB()
{
  OwnInterlock().unlock();
}
}

#endif
