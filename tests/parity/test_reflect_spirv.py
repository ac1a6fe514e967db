#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shaders are compiled and reflected as the build does it: what a header says is what the shader declares, and what
pipelines cannot hold is refused with the shader's name."""
import os
import subprocess
import sys
import tempfile
import unittest

REFLECT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "reflect_spirv.py")
GLSLC = os.environ.get("GLSLC", "glslc")
HEAD = "#version 460\n"
COMPUTE = HEAD + "layout(local_size_x = 64) in;\n"


class Reflecting(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def compile(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        for suffix, level in ((".inc", "-O"), (".named", "-O0")):
            subprocess.run([GLSLC, "--target-env=vulkan1.3", "-mfmt=c", level, "-o", path + suffix, path], check=True)
        return [path + ".inc", path + ".named"]

    def reflect(self, name, **shaders):
        """(exit status, header or message)"""
        files = [f for stage, text in shaders.items() for f in self.compile(f"{name}.{stage}", text)]
        header = os.path.join(self.folder.name, name + "_shader.h")
        done = subprocess.run([sys.executable, REFLECT, name, header, *files], stderr=subprocess.PIPE, text=True,
                              check=False)
        if done.returncode != 0:
            return done.returncode, done.stderr
        with open(header, encoding="utf-8") as file:
            return 0, file.read()

    def test_every_kind_of_binding_has_its_name_number_and_type(self):
        status, header = self.reflect("all_kinds", comp=COMPUTE + """
            layout(std140, binding = 7) uniform Few { vec4 few[4]; };
            layout(std430, binding = 2) readonly buffer Many { float many[]; };
            layout(binding = 3) uniform sampler2DArray image;
            layout(binding = 5, rgba16f) writeonly uniform image2D written;
            layout(std430, binding = 9) buffer Block { uint at[]; } named;
            void main() { imageStore(written, ivec2(0), few[1] * many[0] + texelFetch(image, ivec3(0), 0));
                          named.at[0] = 1; }""")
        self.assertEqual(status, 0)
        self.assertIn("swBinding many;\n    swBinding image;\n    swBinding written;\n    swBinding few;\n"
                      "    swBinding named;\n} swAllKindsBindings;", header)
        for number, kind in ((2, "STORAGE_BUFFER"), (3, "COMBINED_IMAGE_SAMPLER"), (5, "STORAGE_IMAGE"),
                             (7, "UNIFORM_BUFFER"), (9, "STORAGE_BUFFER")):
            self.assertIn(f"{{{number}, VK_DESCRIPTOR_TYPE_{kind}}}", header)
        self.assertIn(".bindingCount = 5,", header)
        self.assertIn("swBindAllKinds(", header)

    def test_a_binding_that_is_not_used_is_there_all_the_same(self):
        _, header = self.reflect("unused", comp=COMPUTE + """
            layout(std430, binding = 0) buffer Used { float used[]; };
            layout(std430, binding = 1) buffer Idle { float idle[]; };
            void main() { used[0] = 1.0; }""")
        self.assertIn("swBinding used;\n    swBinding idle;", header)

    def test_push_constants_are_as_large_as_their_last_member_ends(self):
        body = "void main() { if (a > 100.0) { return; } }"
        for block, size in (("float a;", 4), ("vec2 b; float a;", 12), ("uint c; vec4 b; float a;", 36),
                            ("float a; mat4 m;", 80), ("float a; vec4 list[3];", 64)):
            _, header = self.reflect("pushed", comp=COMPUTE + f"layout(push_constant) uniform Push {{ {block} }};{body}")
            self.assertIn(f"#define SW_PUSHED_PUSH_SIZE {size}\n", header)

    def test_nested_structs_of_push_constants_are_measured(self):
        _, header = self.reflect("nested", comp=COMPUTE + """
            struct Inner { uint count; float x, y; };
            layout(push_constant) uniform Push { Inner inner; uint last; };
            void main() { if (last > 100) { return; } }""")
        self.assertIn("#define SW_NESTED_PUSH_SIZE 16\n", header)

    def test_constants_are_members_in_the_order_of_their_ids(self):
        _, header = self.reflect("constants", comp=HEAD + """
            layout(constant_id = 4) const bool LAST_ONE = false;
            layout(constant_id = 0) const uint FFT_SIZE = 128;
            layout(local_size_x_id = 1) in;
            layout(std430, binding = 0) buffer Out { uint text[]; };
            void main() { text[gl_LocalInvocationIndex] = FFT_SIZE * gl_WorkGroupSize.x + (LAST_ONE ? 1 : 0); }""")
        self.assertIn("uint32_t fftSize;\n    uint32_t workgroupX;\n    uint32_t lastOne;\n}", header)
        self.assertIn(".constantIds = {0, 1, 4},", header)

    def test_two_stages_share_one_set(self):
        vert = HEAD + """
            layout(std430, binding = 0) readonly buffer Picture { vec4 picture[]; };
            layout(std430, binding = 1) readonly buffer Tiles { vec4 tiles[]; };
            void main() { gl_Position = picture[0] + tiles[1]; }"""
        frag = HEAD + """
            layout(std430, binding = 0) readonly buffer Picture { vec4 picture[]; };
            layout(binding = 4) uniform sampler2D sky;
            layout(location = 0) out vec4 color;
            void main() { color = picture[2] * texture(sky, vec2(0.0)); }"""
        _, header = self.reflect("pair", vert=vert, frag=frag)
        self.assertIn("swBinding picture;\n    swBinding tiles;\n    swBinding sky;\n} swPairBindings;", header)
        self.assertIn("swShader swPairVertex", header)
        self.assertIn("swShader swPairFragment", header)

    def check_refused(self, part, **shaders):
        status, message = self.reflect("bad", **shaders)
        self.assertNotEqual(status, 0)
        self.assertIn("bad", message)
        self.assertIn(part, message)

    def test_stages_that_disagree_are_refused(self):
        vert = HEAD + "layout(std430, binding = 0) readonly buffer A { vec4 a[]; }; void main() { gl_Position = a[0]; }"
        frag = HEAD + """layout(binding = 0) uniform sampler2D b; layout(location = 0) out vec4 color;
                         void main() { color = texture(b, vec2(0.0)); }"""
        self.check_refused("binding 0", vert=vert, frag=frag)

    def test_what_pipelines_cannot_hold_is_refused(self):
        self.check_refused("set 0", comp=COMPUTE + """layout(set = 1, binding = 0) buffer A { float a[]; };
                                                      void main() { a[0] = 1.0; }""")
        self.check_refused("kind", comp=COMPUTE + """layout(binding = 0) uniform sampler2D many[3];
            layout(std430, binding = 1) buffer A { vec4 a; }; void main() { a = textureLod(many[1], vec2(0.0), 0.0); }""")
        self.check_refused("128 bytes", comp=COMPUTE + """layout(push_constant) uniform P { vec4 a[9]; };
                                                          void main() { if (a[8].x > 1.0) { return; } }""")
        bindings = "".join(f"layout(std430, binding = {i}) buffer B{i} {{ float b{i}; }};" for i in range(26))
        self.check_refused("26 bindings", comp=COMPUTE + bindings + "void main() { b0 = 1.0; }")

    def test_a_file_that_is_no_spirv_is_refused(self):
        path = os.path.join(self.folder.name, "bad.comp.inc")
        with open(path, "w", encoding="utf-8") as file:
            file.write("{1, 2, 3}")
        done = subprocess.run([sys.executable, REFLECT, "bad", path + ".h", path, path], stderr=subprocess.PIPE,
                              text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no SPIR-V", done.stderr)
        self.assertFalse(os.path.exists(path + ".h"))


if __name__ == "__main__":
    unittest.main()
