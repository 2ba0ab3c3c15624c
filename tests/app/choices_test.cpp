// A closed set is one table: its names are read, written, listed and refused from there alone.

#include <doctest/doctest.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "app/arguments/values.h"
#include "app/run/report.h"
#include "render/backend/devices.h"
#include "render/settings/settings.h"

using namespace ropelight;

namespace {
enum class Dummy { first, second };
}  // namespace

template <>
struct ropelight::ChoicesOf<Dummy> {
  static constexpr Choice<Dummy> table[] = {{Dummy::first, "the-first", ""}, {Dummy::second, "second", ""}};
};

namespace {

template <class E>
void checkTable() {
  std::vector<std::string> const names = namesOf<E>();
  for (const auto& row : ChoicesOf<E>::table) {
    CHECK(nameOf(row.value) == std::string(row.name));
    CHECK(findChoice<E>(row.name) == row.value);
    CHECK(std::count(names.begin(), names.end(), row.name) == 1);
    CHECK(std::string(row.doc) != "");
  }
  CHECK_FALSE(findChoice<E>("").has_value());
}

/// The built-in rows and one more.
template <class Row, std::size_t n>
std::vector<Row> withRow(const Row (&table)[n], Row row) {
  std::vector<Row> rows(std::begin(table), std::end(table));
  rows.push_back(row);
  return rows;
}

}  // namespace

TEST_CASE("every closed set names each of its values once") {
  Settings settings;
  settings.params([](const char*, const auto& value, const ParamInfo& info) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (ChoiceEnum<T>) {
      checkTable<T>();
      CHECK(info.choices.size() == std::size(ChoicesOf<T>::table));
    } else {
      CHECK(info.choices.empty());
    }
  });
  checkTable<BackendKind>();
}

TEST_CASE("a new set needs its table alone") {
  Dummy value = Dummy::first;
  parseValue("--dummy", "second", {}, value);
  CHECK(value == Dummy::second);
  CHECK(formatValue(value) == "second");
  CHECK(written(Dummy::first) == std::string("the-first"));
  CHECK_THROWS_WITH_AS(parseValue("--dummy", "third", {}, value),
                       "--dummy: 'third' is not known; use one of: the-first, second", Error);
  CHECK(value == Dummy::second);
}

TEST_CASE("an AOV and a mode are a row of their table") {
  auto const aovs = withRow<AovChoice>(ChoicesOf<Aov>::table, {{Aov(8), "dummy", "of this test"}, AovSource::firstHit});
  CHECK(isInOrder(aovs));
  CHECK(findRow(aovs, "dummy")->source == AovSource::firstHit);
  CHECK_THROWS_WITH_AS(refuseChoice("--aov", "x", aovs), doctest::Contains("gather-radius, dummy"), Error);
  auto const modes = withRow<Choice<Mode>>(ChoicesOf<Mode>::table, {Mode(3), "dummy", "of this test"});
  CHECK(isInOrder(modes));
  CHECK(findRow(modes, "dummy")->value == Mode(3));
  CHECK_THROWS_WITH_AS(refuseChoice("--mode", "x", modes), doctest::Contains("use one of: ray, path, sppm, dummy"),
                       Error);
}

TEST_CASE("JSON and metadata hold the names") {
  Settings settings;
  settings.aov = Aov::photonCount;
  settings.accel = Accel::shortStack;
  auto const json = toJson(settings);
  CHECK(json["aov"] == "photon-count");
  CHECK(json["accel"] == "short-stack");
  for (const auto& [name, value] : imageMetadata(settings, {}, {}))
    if (name == "aov") CHECK(std::get<std::string>(value) == "photon-count");
}
