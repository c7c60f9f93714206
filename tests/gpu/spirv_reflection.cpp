#include "tests/gpu/spirv_reflection.h"

#include <cstring>
#include <spirv/unified1/spirv.hpp>
#include <vector>

namespace vamp::test {
namespace {

// What a module says of its structs, by type id (SPIR-V specification, section 2.3 "Physical Layout").
struct Module {
  std::map<uint32_t, std::string> names;
  std::map<uint32_t, std::map<uint32_t, std::string>> member_names;
  std::map<uint32_t, std::map<uint32_t, uint32_t>> member_offsets;
  std::map<uint32_t, uint32_t> array_strides;  // by array type
  std::map<uint32_t, uint32_t> element_types;  // by array type
};

// A nul-terminated string packed into words.
std::string text(std::span<const uint32_t> words) {
  const char* first = reinterpret_cast<const char*>(words.data());
  return {first, strnlen(first, words.size_bytes())};
}

void read(Module& module, spv::Op op, std::span<const uint32_t> args) {
  switch (op) {
    case spv::OpName:
      if (args.size() >= 2) module.names[args[0]] = text(args.subspan(1));
      break;
    case spv::OpMemberName:
      if (args.size() >= 3) module.member_names[args[0]][args[1]] = text(args.subspan(2));
      break;
    case spv::OpMemberDecorate:
      if (args.size() >= 4 && args[2] == spv::DecorationOffset) module.member_offsets[args[0]][args[1]] = args[3];
      break;
    case spv::OpDecorate:
      if (args.size() >= 3 && args[1] == spv::DecorationArrayStride) module.array_strides[args[0]] = args[2];
      break;
    case spv::OpTypeArray:
    case spv::OpTypeRuntimeArray:
      if (args.size() >= 2) module.element_types[args[0]] = args[1];
      break;
    default:
      break;
  }
}

}  // namespace

Result<SpirvStruct> reflect_struct(std::span<const uint32_t> spirv, const std::string& name) {
  const auto wrong = [&](const char* expected, const std::string& found) {
    return fail(ErrorKind::bad_input, "SPIR-V", "struct " + name, expected, found);
  };
  if (spirv.size() < 5 || spirv[0] != spv::MagicNumber) return wrong("a SPIR-V module", "other words");
  Module module;
  for (size_t at = 5; at < spirv.size();) {
    const uint32_t count = spirv[at] >> 16;
    if (count == 0 || count > spirv.size() - at) return wrong("whole instructions", "a cut one");
    read(module, static_cast<spv::Op>(spirv[at] & 0xffff), spirv.subspan(at + 1, count - 1));
    at += count;
  }

  // Types without offsets are copies for local variables; those with offsets must agree.
  SpirvStruct result;
  for (const auto& [type, offsets] : module.member_offsets) {
    if (module.names[type] != name) continue;
    SpirvStruct one;
    for (const auto& [member, offset] : offsets) one.offsets[module.member_names[type][member]] = offset;
    for (const auto& [array, element] : module.element_types)
      if (element == type && module.array_strides.contains(array)) one.stride = module.array_strides[array];
    if (!result.offsets.empty() && result.offsets != one.offsets) return wrong("one layout", "two");
    if (result.stride != 0 && one.stride != 0 && result.stride != one.stride) return wrong("one stride", "two");
    result.offsets = one.offsets;
    if (one.stride != 0) result.stride = one.stride;
  }
  if (result.offsets.empty()) return wrong("offsets of its members", "none");
  return result;
}

}  // namespace vamp::test
