// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause

// Many threads store fragments of few pixels, as a GPU's invocations do: the shaders' own text under ThreadSanitizer
// (ShaderAsCxx.h says how GLSL's memory is modelled). It ends the program at the first race.
#include "ConcurrentShader.h"

#include "Storage/CellLayout.glsl"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <string_view>
#include <thread>
#include <tuple>

namespace
{
constexpr int Threads = 6;
constexpr int FragmentsOfThread = 600;
constexpr int Fragments = Threads * FragmentsOfThread;
constexpr int RaceFound = 66; // ThreadSanitizer's exit code

constexpr DrawnTile Tile{ 5, 7, 3, 3, 1 }; // of 4 cells
constexpr DrawnTile TileOfOneCell{ 5, 7, 3, 3, 2 };

// Gives each thread as many numbers of fragments; they begin when all are there.
void RunThreads(const std::function<void(int number)>& work)
{
  std::atomic<int> waiting{ Threads };
  std::vector<std::thread> threads;
  for (int thread = 0; thread < Threads; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        --waiting;
        while (waiting > 0)
        {
          std::this_thread::yield();
        }
        for (int i = 0; i < FragmentsOfThread; ++i)
        {
          work(thread * FragmentsOfThread + i);
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

// Each is another one, and each pixel has some of every thread.
DrawnFragment FragmentOf(const StorageVariant& variant, int number)
{
  const auto word = static_cast<std::uint32_t>(number);
  DrawnFragment fragment{ Tile.X + number % Tile.Width, Tile.Y + number / Tile.Width % Tile.Height,
    static_cast<float>(number) / Fragments, { word * 2654435761u, word * 40503u, ~word }, 1u };
  for (int i = variant.ColorWords; i < 3; ++i)
  {
    fragment.Color[i] = 0;
  }
  if (variant.Samples > 1)
  {
    fragment.Coverage = 1u + word % ((1u << variant.Samples) - 1u);
  }
  return fragment;
}

auto Content(const DrawnFragment& fragment)
{
  return std::tie(fragment.Y, fragment.X, fragment.Depth, fragment.Color, fragment.Coverage);
}

bool Before(const DrawnFragment& a, const DrawnFragment& b)
{
  return Content(a) < Content(b);
}

int CellOf(const DrawnTile& tile, const DrawnFragment& fragment)
{
  const int cellsPerRow = ((tile.Width - 1) >> tile.CellShift) + 1;
  return ((fragment.Y - tile.Y) >> tile.CellShift) * cellsPerRow + ((fragment.X - tile.X) >> tile.CellShift);
}

std::vector<std::uint32_t> FragmentsOfCells(const StorageVariant& variant, const DrawnTile& tile)
{
  std::vector<std::uint32_t> counts;
  for (int number = 0; number < Fragments; ++number)
  {
    const std::size_t cell = CellOf(tile, FragmentOf(variant, number));
    counts.resize(std::max(counts.size(), cell + 1));
    ++counts[cell];
  }
  return counts;
}

void StoreAll(ConcurrentStorage& storage, const StorageVariant& variant)
{
  RunThreads([&](int number) { storage.Store(FragmentOf(variant, number), false); });
}

std::vector<DrawnFragment> ReadAll(ConcurrentStorage& storage)
{
  std::vector<DrawnFragment> found;
  for (int y = 0; y < Tile.Height; ++y)
  {
    for (int x = 0; x < Tile.Width; ++x)
    {
      const std::vector<DrawnFragment> pixel = storage.Read(Tile.X + x, Tile.Y + y);
      found.insert(found.end(), pixel.begin(), pixel.end());
    }
  }
  return found;
}

void ExpectAll(ConcurrentStorage& storage, const StorageVariant& variant)
{
  std::vector<DrawnFragment> expected;
  for (int number = 0; number < Fragments; ++number)
  {
    expected.push_back(FragmentOf(variant, number));
  }
  std::vector<DrawnFragment> found = ReadAll(storage);
  std::sort(expected.begin(), expected.end(), Before);
  std::sort(found.begin(), found.end(), Before);
  ASSERT_EQ(found.size(), expected.size());
  for (int i = 0; i < Fragments; ++i)
  {
    ASSERT_EQ(Content(found[i]), Content(expected[i]));
  }
}

std::uint32_t CountUnits(ConcurrentStorage& storage, int cell)
{
  return storage.GetWord(cell, CELL_NEXT) - storage.GetWord(cell, CELL_FIRST);
}

// As the application learns it.
std::uint32_t CountFragments(ConcurrentStorage& storage, const StorageVariant& variant, int cell)
{
  return variant.Storage == "Sections" ? storage.GetWord(cell, CELL_FRAGMENTS) : CountUnits(storage, cell);
}

const StorageVariant& StorageNamed(std::string_view name)
{
  const auto& all = StorageVariants();
  return *std::find_if(all.begin(), all.end(), [&](const StorageVariant& variant) { return variant.Name == name; });
}

const RecordVariant& RecordsUnder(std::string_view name)
{
  const auto& all = RecordVariants();
  return *std::find_if(all.begin(), all.end(), [&](const RecordVariant& variant) { return variant.Name == name; });
}

// All fragments of a pixel have different depths.
float DepthOf(int number)
{
  return static_cast<float>(number * 7 % Fragments) / Fragments;
}

float ColorOf(int number)
{
  return static_cast<float>(number % 8) / 8;
}

constexpr float Opacity = 0.5f;
constexpr int Pixels = Tile.Width * Tile.Height;

void DrawAll(ConcurrentRecords& records)
{
  records.Begin(Tile);
  RunThreads(
    [&](int number)
    {
      const int pixel = number % Pixels;
      records.Draw(
        Tile.X + pixel % Tile.Width, Tile.Y + pixel / Tile.Width, DepthOf(number), ColorOf(number), Opacity, false);
    });
}

// With a race that must be found: in a process of its own, which ends there.
void StoreWith(Fault fault, const char* storage)
{
  PresentFault = fault;
  const StorageVariant& variant = StorageNamed(storage);
  const auto shader = variant.New();
  shader->Begin(TileOfOneCell, { Fragments });
  StoreAll(*shader, variant);
}

void DrawWith(Fault fault, const char* criticalSection)
{
  PresentFault = fault;
  DrawAll(*RecordsUnder(criticalSection).New());
}
}

// Asked by ThreadSanitizer, of its own library, before main.
extern "C" __attribute__((visibility("default"))) const char* __tsan_default_options();
extern "C" const char* __tsan_default_options()
{
  return "halt_on_error=1";
}

//------------------------------------------------------------------------------
class TestConcurrentStorage : public testing::TestWithParam<StorageVariant>
{
protected:
  std::unique_ptr<ConcurrentStorage> Storage = GetParam().New();
};

TEST_P(TestConcurrentStorage, KeepsEachFragmentOnce)
{
  const std::vector<std::uint32_t> counts = FragmentsOfCells(GetParam(), Tile);
  this->Storage->Begin(Tile, counts); // a fragment takes a unit at most
  StoreAll(*this->Storage, GetParam());
  ExpectAll(*this->Storage, GetParam());
  const std::vector<std::uint32_t> pixels{ 4, 2, 2, 1 };
  for (int cell = 0; cell < 4; ++cell)
  {
    EXPECT_EQ(CountFragments(*this->Storage, GetParam(), cell), counts[cell]);
    EXPECT_LE(CountUnits(*this->Storage, cell), counts[cell]);
    EXPECT_EQ(this->Storage->GetWord(cell, CELL_PIXELS), GetParam().OwnSections ? pixels[cell] : 0u);
    EXPECT_EQ(this->Storage->GetWord(cell, CELL_STORES), GetParam().CountsAccesses ? counts[cell] : 0u);
  }
}

// Of one cell. Of several, a cell that has too little room counts on in the next one's: what two of them then store in
// one place is a race, and the frame is drawn again.
TEST_P(TestConcurrentStorage, CountsToTheEndWhatFindsNoRoom)
{
  constexpr int MostRounds = 20;
  std::uint32_t room = Fragments / 100;
  int rounds = 0;
  std::uint32_t needed = 0;
  do
  {
    this->Storage->Begin(TileOfOneCell, { room });
    StoreAll(*this->Storage, GetParam());
    EXPECT_EQ(CountFragments(*this->Storage, GetParam(), 0), static_cast<std::uint32_t>(Fragments));
    needed = CountUnits(*this->Storage, 0);
    if (needed > room)
    {
      room = needed + needed / 8; // as vtkCellStorage does: sections that are left empty are others in each round
    }
    else
    {
      needed = 0;
    }
    ASSERT_LE(++rounds, MostRounds);
  } while (needed > 0);
  EXPECT_GT(rounds, 1);
  ExpectAll(*this->Storage, GetParam());
}

INSTANTIATE_TEST_SUITE_P(InAnyOrder, TestConcurrentStorage, testing::ValuesIn(StorageVariants()),
  [](const auto& info) { return info.param.Name; });

//------------------------------------------------------------------------------
TEST(TestConcurrentPlaces, AreGivenOutOnce)
{
  constexpr std::uint32_t Room = Fragments / 2;
  const auto storage = StorageNamed("LinkedList").New();
  storage->Begin(TileOfOneCell, { Room });
  std::vector<std::uint32_t> places(Fragments);
  RunThreads([&](int number) { places[number] = storage->TakePlace(TileOfOneCell.X, TileOfOneCell.Y); });
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> expected(Room);
  std::iota(expected.begin(), expected.end(), 0u);
  expected.resize(Fragments, 0xffffffffu); // no room
  EXPECT_EQ(places, expected);
  EXPECT_EQ(storage->GetWord(0, CELL_INSERTED), static_cast<std::uint32_t>(Fragments));
}

//------------------------------------------------------------------------------
class TestConcurrentRecords : public testing::TestWithParam<const char*>
{
};

TEST_P(TestConcurrentRecords, HoldTheNearestAndTheSumsOfAllOthers)
{
  const auto records = RecordsUnder(GetParam()).New();
  DrawAll(*records);
  for (int pixel = 0; pixel < Pixels; ++pixel)
  {
    std::vector<std::pair<float, float>> expected; // depths and colours
    for (int number = pixel; number < Fragments; number += Pixels)
    {
      expected.emplace_back(DepthOf(number), ColorOf(number));
    }
    std::sort(expected.begin(), expected.end());
    const ConcurrentRecords::Record record = records->Read(Tile.X + pixel % Tile.Width, Tile.Y + pixel / Tile.Width);
    ASSERT_EQ(record.Depths.size(), static_cast<std::size_t>(ConcurrentRecords::Layers));
    float tailColor = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      if (i < record.Depths.size())
      {
        EXPECT_EQ(record.Depths[i], expected[i].first);
      }
      else
      {
        tailColor += Opacity * expected[i].second;
      }
    }
    EXPECT_EQ(record.TailColor, tailColor); // few bits each: sums are exact in any order
    EXPECT_EQ(record.TailOpacity, Opacity * static_cast<float>(expected.size() - ConcurrentRecords::Layers));
  }
}

INSTANTIATE_TEST_SUITE_P(
  Under, TestConcurrentRecords, testing::Values("Spinlock", "Interlock"), [](const auto& info) { return info.param; });

//------------------------------------------------------------------------------
TEST(TestHelperInvocations, DoNotWaitForALock)
{
  const auto records = RecordsUnder("Spinlock").New();
  records->Begin(Tile);
  records->TakeLock(Tile.X, Tile.Y);
  records->Draw(Tile.X, Tile.Y, 0.5f, 1.0f, Opacity, true);
  EXPECT_TRUE(records->Read(Tile.X, Tile.Y).Depths.empty());
}

TEST(TestHelperInvocations, StoreNothingInSections)
{
  const auto storage = StorageNamed("Sections4").New();
  storage->Begin(TileOfOneCell, { Fragments });
  storage->Store(FragmentOf(StorageNamed("Sections4"), 0), true);
  EXPECT_TRUE(ReadAll(*storage).empty());
  EXPECT_EQ(storage->GetWord(0, CELL_FRAGMENTS), 0u);
}

//------------------------------------------------------------------------------
// Whether the tests above can tell: each breaks what one of them relies on.
class TestRacesAreFound : public testing::Test
{
protected:
  void SetUp() override { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

TEST_F(TestRacesAreFound, WhereTheLockIsTakenOut)
{
  EXPECT_EXIT(DrawWith(Fault::None, "None"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST_F(TestRacesAreFound, WhereTheLockIsNotAtomic)
{
  EXPECT_EXIT(DrawWith(Fault::PlainCompSwap, "Spinlock"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST_F(TestRacesAreFound, WhereTheLocksFirstBarrierIsTakenOut)
{
  EXPECT_EXIT(DrawWith(Fault::NoFirstBarrier, "Spinlock"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST_F(TestRacesAreFound, WhereTheLocksSecondBarrierIsTakenOut)
{
  EXPECT_EXIT(DrawWith(Fault::NoSecondBarrier, "Spinlock"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST_F(TestRacesAreFound, WhereNodesAreNotTakenAtomically)
{
  EXPECT_EXIT(StoreWith(Fault::PlainAdd, "LinkedList"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST_F(TestRacesAreFound, WhereEntriesOfSectionsAreNotSwappedAtomically)
{
  EXPECT_EXIT(StoreWith(Fault::PlainCompSwap, "Sections4"), testing::ExitedWithCode(RaceFound), "data race");
}

TEST(TestLossesAreFound, WhereHeadsAreExchangedInTwoSteps)
{
  PresentFault = Fault::SplitExchange;
  const StorageVariant& variant = StorageNamed("LinkedList");
  const auto storage = variant.New();
  storage->Begin(TileOfOneCell, { Fragments });
  StoreAll(*storage, variant);
  EXPECT_LT(ReadAll(*storage).size(), static_cast<std::size_t>(Fragments));
  PresentFault = Fault::None;
}
