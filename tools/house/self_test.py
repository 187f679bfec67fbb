"""The rules on small texts: each finds what is wrong, there and only there, and lets its neighbour pass."""

from house import docstrings, layers, wording

HEADER = """#pragma once
namespace vernier {
/// Documented.
int good(int a);
int good(float a);
int bad(std::function<void(int)> f);

/// A type.
struct Thing {
  glm::vec4 color = glm::vec4(1.0f);
  std::function<void(int)> callback;
  explicit Thing(int a) : a_{a}, b_(a) {}
  ~Thing();
  Thing(const Thing&) = delete;
  int size() const { return size_; }
  int grow(int by) {
    size_ += by;
    return size_;
  }
 private:
  /// Documented.
  template <typename T>
  T twice(T value) const { return value + value; }
  bool operator<(const Thing& other) const;
};
class Shelf : public Thing {
  int hidden(int a);
 public:
  int shown(int a);
  int size(int a) const override;
 protected:
  int half_shown(int a);
 private:
  int hidden_too(int a);
  int with_body(int a) {
    return a;
  }
};
int after(int a);
enum class Kind { first = 1, second = first };
inline constexpr int kOne = one(1);
}  // namespace vernier
"""

SHADER = """// Twice x.
float twice(float x) { return x + x; }

float thrice(float x) {
  const float tiny = 1e-6f;
  float small = 1e-4f;  // half of what matters
  return 3.0f * x;
}
"""

EFFECTS = "#define EFFECT_A (1u << 0)\n#define EFFECT_B (1u << 1)\n#define EFFECT_COUNT 2u\n"

# (rule, files, the findings as (path, line))
CASES = [
    (docstrings.check_docstrings, {"src/math/a.h": HEADER},
     [("src/math/a.h", 6), ("src/math/a.h", 16), ("src/math/a.h", 29), ("src/math/a.h", 32),
      ("src/math/a.h", 39)]),
    (docstrings.check_docstrings, {"shaders/a.glsl": SHADER, "shaders/b.comp": "x = twice(thrice(x));"},
     [("shaders/a.glsl", 4)]),
    (docstrings.check_docstrings, {"shaders/a.glsl": SHADER}, []),
    (docstrings.check_docstrings, {"src/gpu/a.h": "template <typename T>\ndecltype(auto) checked(T call) {\n  call();\n}\n"},
     [("src/gpu/a.h", 1)]),
    (docstrings.check_docstrings, {"src/math/a.cpp": "int undocumented();\n"}, []),
    (layers.check_layers, {"src/bvh/a.cpp": '#include "bvh/bvh.h"\n#include "math/ray.h"\n#include "scene/scene.h"\n'},
     [("src/bvh/a.cpp", 3)]),
    (layers.check_layers, {"src/gpu/a.h": '#include "bvh/bvh.h"\n', "src/reference/a.h": '#include "gpu/device.h"\n',
                           "src/scene/a.h": '#include "render/film.h"\n#include "shared/effects.h"\n',
                           "src/cli/a.cpp": '#include "render/film.h"\n#include "error.h"\n'},
     [("src/gpu/a.h", 1), ("src/reference/a.h", 1), ("src/scene/a.h", 1)]),
    (layers.check_layers, {"src/gpu/CMakeLists.txt": "vernier_library(gpu\n  LINKS vernier_scene\n)\n"},
     [("src/gpu/CMakeLists.txt", 2)]),
    (layers.check_layers, {"src/stuff/a.h": "\n"}, [("src/stuff/a.h", 1)]),
    (wording.check_names, {"src/math/math_utils.h": "\n", "src/scene/manage.h": "class TextureManager {};\nclass Imp {};\n",
                           "src/gpu/a.cpp": "int upload_helper(int a) {\n}\nvec3 base_color() {\n}\n"},
     [("src/math/math_utils.h", 1), ("src/scene/manage.h", 1), ("src/gpu/a.cpp", 1)]),
    (wording.check_lines, {"src/a.cpp": "\n" * 301, "src/b.cpp": "\n" * 300, "README.md": "\n" * 400}, [("src/a.cpp", 301)]),
    (wording.check_lines, {"src/a.cpp": "// fine\n// TO" + "DO later\n", "tools/b": "cd /ho" + "me/me\nls $x/ho" + "me/a\n"},
     [("src/a.cpp", 2), ("tools/b", 1)]),
    (wording.check_tolerances, {"shaders/a.glsl": SHADER, "src/a.cpp": "x = 1e-6;\n"}, [("shaders/a.glsl", 5)]),
    (wording.check_tolerances, {"shaders/b.glsl": "a = 0.0001f;\nb = 0x1p-24f;\n// one ulp\nc = 0x1p-23f;\nd = 0.5f;\n"},
     [("shaders/b.glsl", 1), ("shaders/b.glsl", 2)]),
    (wording.check_effects, {"shaders/shared/effects.h": EFFECTS, "src/effects/a.cpp": "EFFECT_A EFFECT_BC"},
     [("shaders/shared/effects.h", 2)]),
    (wording.check_effects, {"shaders/shared/effects.h": EFFECTS.replace("2u", "3u"),
                             "src/effects/a.cpp": "EFFECT_A EFFECT_B"}, [("shaders/shared/effects.h", 1)]),
    (wording.check_top_level, ["src/a.h", ".ci/run", "notes.md"], [("notes.md", 1)]),
]


def run_self_test() -> int:
    """Runs all cases, prints those that differ and returns the exit code."""
    failures = 0
    for rule, files, expected in CASES:
        found = [(finding.path, finding.line) for finding in rule(files)]
        if sorted(found) != sorted(expected):
            failures += 1
            print(f"{rule.__name__} on {list(files)}: found {found}, expected {expected}")
    print(f"{len(CASES) - failures} of {len(CASES)} cases pass")
    return 1 if failures else 0
