// Host and shader agree on every struct of layout.h: offsets, sizes, strides and types.

#include "shaders/layout.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "shaders/layout.spv.h"
#include "tests/conformance/fields.h"
#include "tests/conformance/fixture.h"

#include <cstddef>
#include <cstring>
#include <numeric>
#include <type_traits>

namespace dsphere::conformance {
namespace {

using gpu::Binding;
using gpu::Buffer;

using Layout = Conformance;

/// A struct's words as its list of fields has them; `in_order` if each field follows the one before without a gap.
struct Listed {
    std::size_t words = 0;
    bool in_order = true;

    template <typename Expected, typename Field>
    constexpr void add(std::size_t offset) {
        in_order = in_order && offset == words * 4 && std::is_same_v<Expected, Field>;
        words += sizeof(Field) / 4;
    }
};

#define V(name) listed.add<layout::vec4, decltype(Subject::name)>(offsetof(Subject, name));
#define F(name) listed.add<float, decltype(Subject::name)>(offsetof(Subject, name));
#define I(name) listed.add<int, decltype(Subject::name)>(offsetof(Subject, name));
#define U(name) listed.add<layout::uint, decltype(Subject::name)>(offsetof(Subject, name));
#define EXPECT_LISTED(type, fields)                            \
    do {                                                       \
        using Subject = layout::type;                          \
        Listed listed;                                         \
        fields;                                                \
        EXPECT_TRUE(listed.in_order) << #type;                 \
        EXPECT_EQ(listed.words * 4, sizeof(Subject)) << #type; \
    } while (false)

// A field that layout.h gained and fields.h did not would go untested.
TEST_F(Layout, ListsHoldEveryField) {
    EXPECT_LISTED(ObjectData, OBJECT_FIELDS(V, F, I));
    EXPECT_LISTED(MapData, MAP_FIELDS(F, I));
    EXPECT_LISTED(LightData, LIGHT_FIELDS(V, F, I));
    EXPECT_LISTED(MaterialData, MATERIAL_FIELDS(V, F, I));
    EXPECT_LISTED(TriangleData, TRIANGLE_FIELDS(V));
    EXPECT_LISTED(ProbeRay, PROBE_RAY_FIELDS(V, U));
    EXPECT_LISTED(ProbeHit, PROBE_HIT_FIELDS(V, U));
    EXPECT_LISTED(RenderParams, PARAMS_FIELDS(I, U));
}

#undef V
#undef F
#undef I
#undef U

/// Fills structs with successive words, and keeps what must come back. As floats the words are 2 and a little more: no
/// denormal or NaN whose bits a device may change.
class Pattern {
  public:
    template <typename T>
    T next() {
        std::vector<std::uint32_t> words(sizeof(T) / 4);
        std::iota(words.begin(), words.end(), std::uint32_t(0x40000000u + expected_.size()));
        expected_.insert(expected_.end(), words.begin(), words.end());
        T value;
        std::memcpy(&value, words.data(), sizeof(T));
        return value;
    }

    const std::vector<std::uint32_t>& expected() const { return expected_; }

  private:
    std::vector<std::uint32_t> expected_;
};

template <typename T>
Buffer filled(Buffer::Usage usage, const T (&values)[2], const char* name) {
    Buffer buffer(device(), usage, Buffer::Place::Device, sizeof(values), name);
    buffer.upload(0, sizeof(values), values);
    return buffer;
}

TEST_F(Layout, WordsComeBackInOrder) {
    if (onHost()) GTEST_SKIP() << "the host reads C++'s structs themselves";
    Pattern pattern;
    layout::ObjectData objects[2];
    layout::MapData maps[2];
    layout::LightData lights[2];
    layout::MaterialData materials[2];
    layout::TriangleData triangles[2];
    layout::ProbeRay rays[2];
    layout::ProbeHit hits[2];
    for (std::size_t k = 0; k < 2; ++k) {
        objects[k] = pattern.next<layout::ObjectData>();
        maps[k] = pattern.next<layout::MapData>();
        lights[k] = pattern.next<layout::LightData>();
        materials[k] = pattern.next<layout::MaterialData>();
        triangles[k] = pattern.next<layout::TriangleData>();
        rays[k] = pattern.next<layout::ProbeRay>();
        hits[k] = pattern.next<layout::ProbeHit>();
    }
    auto params = pattern.next<layout::RenderParams>();
    const std::vector<std::uint32_t>& expected = pattern.expected();

    // Objects, maps, lights, materials, triangles; rays, hits, words.
    std::vector<Binding::Kind> bindings(5, Binding::UniformBuffer);
    bindings.insert(bindings.end(), 3, Binding::StorageBuffer);
    gpu::ComputePipeline pipeline(device(), kSpirv_layout, bindings, {}, sizeof(params), "layout");
    Buffer object_buffer = filled(Buffer::Usage::Uniform, objects, "objects");
    Buffer map_buffer = filled(Buffer::Usage::Uniform, maps, "maps");
    Buffer light_buffer = filled(Buffer::Usage::Uniform, lights, "lights");
    Buffer material_buffer = filled(Buffer::Usage::Uniform, materials, "materials");
    Buffer triangle_buffer = filled(Buffer::Usage::Uniform, triangles, "triangles");
    Buffer ray_buffer = filled(Buffer::Usage::Storage, rays, "rays"),
           hit_buffer = filled(Buffer::Usage::Storage, hits, "hits");
    Buffer words(device(), Buffer::Usage::Storage, Buffer::Place::Device, expected.size() * 4, "words");
    gpu::BindingSet set(device(), pipeline,
                        {&object_buffer, &map_buffer, &light_buffer, &material_buffer, &triangle_buffer, &ray_buffer,
                         &hit_buffer, &words},
                        "layout");
    gpu::Batch batch(device(), "layout");
    batch.bind(pipeline, set);
    batch.push(params);
    batch.dispatch(1, 1, 1);
    batch.submit();
    std::vector<std::uint32_t> words_back(expected.size());
    words.download(0, words.size(), words_back.data());
    EXPECT_EQ(words_back, expected);
}

}  // namespace
}  // namespace dsphere::conformance
