#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write a C program that misuses every public function, one argument at a time, from the headers alone.

The contract of the API (include/seaway/base.h) says what misuse does. For every function in include/seaway this tries: NULL
for each pointer, defs that were never initialized, handles that are null or stale, enumerators that do not exist, numbers
that are NaN or infinite, counts below 0; of defs also each field. Nothing may crash; a result must not be success; an object
that was to be made must be NULL; and whoever gave a host, or an object made with one, must be told in a sentence.

A new function is tried without anybody writing anything. What is allowed after all is listed below with its reason.

Usage: scripts/make_misuse_test.py HEADERS_FOLDER OUTPUT.c [--gpu] [--scene]
"""
import os
import re
import sys

HEADERS = ["base", "field", "id", "math", "clock", "spectrum", "measured", "waves", "wind", "tide", "world", "view", "sea", "moment", "query", "replay", "save", "raster", "spline", "hull", "mesh", "island", "input", "wind_sea", "water_body", "measure"]

# (function, argument, misuse): why it is none. "*" stands for any.
ALLOWED = {
    ("swWorld_Save", "data", "NULL"): "asks for the size",
    ("swGpu_GetPipelineCache", "data", "NULL"): "asks for the size",
    ("swCreateMeasuredSea", "name", "NULL"): "a sea may be without a name",
    ("swMeasuredSea_AddLocation", "longitude", "*"): "NaN is a place that is not known",
    ("swMeasuredSea_AddLocation", "latitude", "*"): "NaN is a place that is not known",
    ("swMeasuredSea_AddLocation", "location", "NULL"): "need not be told which it is",
    ("swScene_FindView", "name", "NULL"): "the first view",
    ("swScene_GetSky", "view", "NULL"): "the scene's own sky",
    ("swPrintScene", "text", "NULL"): "asks for the size",
    ("swScene_AddInput", "waves", "-1"): "it weighs all waves, or none of them",
    ("swScene_GetSky", "view", "*"): "a view without a sun of its own, whatever else it is",
    ("swScene_GetSky", "view.*", "*"): "only a sun of its own counts, which the sky's check sees",
    ("swMoment_GetHeight", "x", "*"): "a point that cannot be answered is NaN",
    ("swMoment_GetHeight", "z", "*"): "a point that cannot be answered is NaN",
    ("swMoment_GetStokesDrift", "depthBelow", "*"): "a depth that cannot be answered is NaN; at infinity there is none",
    ("swCreateSeaReplay", "def.startSeconds", "NaN"): "the first record's",
    ("swWaveSystem_IsValid", "*", "*"): "asks just that",
    ("swInput_IsValid", "*", "*"): "asks just that",
    ("swWaterBody_IsValid", "*", "*"): "asks just that",
    ("swWorld_FindWaterBody", "x", "*"): "there is no body where there is no place",
    ("swWorld_FindWaterBody", "z", "*"): "there is no body where there is no place",
    ("swWorld_GetNumberedWaterBody", "number", "-1"): "no body has it",
    ("*", "def.scale", "*"): "counts with SW_SHAPE_HULL only",
    ("*", "def.heading", "*"): "counts with SW_SHAPE_SPLINE only",
    ("*", "def.rounding", "*"): "counts for boxes and cylinders only",
    ("*", "def.gain", "*"): "counts for shapes with values of their own only",
    ("*", "def.feather", "*"): "counts for shapes with an edge only",
    ("*", "def.framesPerSecond", "*"): "counts with SW_SHAPE_RASTER only",
    ("*", "def.startTime", "*"): "counts with SW_SHAPE_RASTER only",
    ("swMeasuredSea_AddLocation", "name", "NULL"): "a place may be without a name",
    ("swMeasuredSea_AddSpectrum", "def.seconds", "NaN"): "a record without a time",
    ("swMeasuredSea_GetRecord", "index", "-1"): "the empty record, as what finds records may give -1",
    ("swMeasuredSea_GetLocation", "location", "-1"): "the empty place, likewise",
    ("swMeasuredSea_FindRecord", "location", "-1"): "any place",
    ("swMeasuredSea_FindRecord", "time", "NULL"): "the largest record",
    ("swMeasuredSea_ChooseRecord", "time", "NULL"): "the largest record",
    ("swMeasuredSea_FindTime", "time", "NULL"): "-1 says that there is none",
    ("swMeasuredSea_FindLocation", "name", "NULL"): "-1 says that there is none",
    ("swFindMeasuredPlace", "text", "NULL"): "-1 says that there is none",
    ("swMeasuredSea_FindNearest", "*", "*"): "-1 says that there is none",
    ("swMeasuredSea_Bracket", "location", "-1"): "false says that there is none",
    ("swMeasuredSea_Bracket", "seconds", "*"): "false says that there is none; infinity is before or after all",
    ("swGpuWorld_ReadLayer", "gpuWorld", "NULL"): "it is the device's world that knows whom to tell",
    ("swGpuWorld_GetLayers", "gpuWorld", "NULL"): "likewise",
    ("swGpu_GetPassTimes", "times", "NULL"): "there is room for none",
    ("swStage_DrawPicture", "stage", "NULL"): "it is the stage that knows whom to tell",
    ("swStage_BeginDrawing", "depth", "NULL"): "drawing without depth",
    ("swStage_DrawPicture", "terrain", "NULL"): "the sea has no land",
    ("swStage_DestroyTerrain", "terrain", "NULL"): "nothing to destroy",
    ("swStage_DestroyTerrain", "stage", "NULL"): "it is the terrain that knows whom to tell",
    ("swStageTerrain_Prepare", "shot.*", "*"): "swPicture_Prepare() checks the shot",
    ("swStage_SubmitFrame", "sync", "NULL"): "waits for nothing and signals nothing",
    ("swGpu_FitView", "def.*", "*"): "swCreateView() checks the def",
    ("swMoment_QueryHeightMap", "map.originX", "*"): "every point is bad, and NaN",
    ("swMoment_QueryHeightMap", "map.originZ", "*"): "every point is bad, and NaN",
    ("swMoment_QueryHeightMap", "map.spacing", "*"): "every point is bad, and NaN",
    ("swCreateSceneInputs", "scene", "NULL"): "it is the scene that knows whom to tell",
    ("swStage_DestroyLines", "lines", "NULL"): "nothing to destroy",
    ("swStageLines_AddQueries", "lines", "NULL"): "it is the lines that know whom to tell",
    ("swStageLines_AddRay", "lines", "NULL"): "likewise",
    ("swStageLines_AddTiles", "lines", "NULL"): "likewise",
    ("swStageLines_AddInputs", "lines", "NULL"): "likewise",
    ("swStageLines_AddMarks", "lines", "NULL"): "likewise",
    ("swSheet_Read", "sheet", "NULL"): "it is the sheet that knows whom to tell",
    ("swCreateSceneSea", "scene", "NULL"): "it is the scene that knows whom to tell",
    ("*", "spectrum.depth", "infinite"): "deep water",
    ("swLookAtPatches", "depth", "infinite"): "deep water",
    ("swLookAtPatches", "index", "-1"): "any place",
    ("swEstimatePatchDensity", "frequency", "*"): "what cannot be answered is NaN",
    ("swEstimatePatchDensity", "theta", "*"): "what cannot be answered is NaN",
    ("swEstimatePatchDensity", "depth", "*"): "what cannot be answered is NaN; infinity is deep water",
    ("swEstimatePatchDensity", "gravity", "*"): "what cannot be answered is NaN",
    ("*", "def.minWavelength", "infinite"): "leaves all waves out",
    ("*", "spectrum.octaves", "zeroed"): "counts with SW_SPECTRUM_OCTAVES only",
    ("*", "octaves.multiplier", "*"): "counts with SW_SPECTRUM_OCTAVES only",
    ("*", "octaves.chop", "*"): "counts with SW_SPECTRUM_OCTAVES only",
    ("*", "octaves.gravityScale", "*"): "counts with SW_SPECTRUM_OCTAVES only",
    ("*", "reverseWeight", "*"): "counts with SW_WAVES_GERSTNER only",
    ("*", "directionVariance", "*"): "counts with SW_WAVES_GERSTNER only",
    ("*", "leastJacobian", "*"): "counts with SW_WAVES_GERSTNER only",
    ("swCreateNest", "def.shape", "*"): "it is a raster's",
    ("swCreateNest", "def.blend", "*"): "each joins by its share",
    ("swWriteRaster", "host", "*"): "it is the host that knows whom to tell",
    ("swReadRaster", "def", "NULL"): "the default",
    ("swReadRaster", "def.missing", "*"): "a number that no file has",
    ("swReadRaster", "def.originEast", "NaN"): "what the file says, or its middle",
    ("swReadRaster", "def.originNorth", "NaN"): "likewise",
    ("swReadRaster", "def.east", "infinite"): "no limit",
    ("swReadRaster", "def.south", "infinite"): "no limit",
    ("swReadRaster", "def.spacingEast", "NaN"): "what the file says",
    ("swReadRaster", "def.spacingNorth", "NaN"): "likewise",
    ("swReadRaster", "def.imageEast", "NaN"): "what the file says",
    ("swReadRaster", "def.imageNorth", "NaN"): "likewise",
    ("swScene_Check", "scene", "NULL"): "it is the scene that knows whom to tell",
    ("swScene_Check", "world", "NULL"): "remarks that need no world",
    ("swScene_Check", "remarks", "NULL"): "there is room for none",
    ("swCreateSeaReplay", "def.waves.spectrum.*", "*"): "a replay's spectra are its records'",
}

# Pointers that may be NULL in every function that has them.
OPTIONAL = {"stats", "slopes", "madeFrom"}


def strip(text):
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r"/\*.*?\*/", "", text, flags=re.S)


def parse(folder, names):
    text = ""
    for name in names:
        with open(os.path.join(folder, name + ".h"), encoding="utf-8") as file:
            text += strip(file.read()) + "\n"
    enums = set(re.findall(r"typedef enum (\w+)", text))
    structs = {}
    for name, body in re.findall(r"typedef struct (\w+)\s*\{(.*?)\}\s*\1\s*;", text, re.S):
        fields = []
        for line in body.split(";"):
            match = re.match(r"\s*(?:const\s+)?(\w+)\s+(\w+(?:\s*,\s*\w+)*)\s*$", line)
            if match:
                fields += [(match.group(1), field.strip()) for field in match.group(2).split(",")]
        structs[name] = fields
    functions = []
    for declaration in re.findall(r"^SW_API\s+(.*?);", text, re.S | re.M):
        declaration = re.sub(r"\s+", " ", declaration)
        match = re.match(r"(.*?)\b(\w+)\((.*)\)$", declaration)
        result, name, arguments = match.group(1).strip(), match.group(2), match.group(3)
        parameters = []
        for argument in [] if arguments == "void" else arguments.split(","):
            argument = re.sub(r"\s(\w+)\[\w+\]$", r"* \1", argument)
            part = re.match(r"\s*(.*?)\s*\b(\w+)$", argument)
            parameters.append((part.group(1).replace(" *", "*").strip(), part.group(2)))
        functions.append((result, name, parameters))
    return enums, structs, functions


class Writer:
    def __init__(self, enums, structs, functions):
        self.enums, self.structs, self.functions = enums, structs, functions
        self.defaults = {result: name for result, name, parameters in functions
                         if name.startswith("swDefault") and not parameters}
        self.cases = []
        self.used = set()

    def base(self, kind):
        return kind.replace("const", "").replace("*", "").strip()

    def valid(self, kind, name, function):
        """An expression that is right in itself; fixtures are in tests/misuse/fixture.h."""
        base = self.base(kind)
        stars = kind.count("*")
        if stars == 2:
            return f"({kind})f->{base[2].lower() + base[3:]}s" if kind.startswith("const") else f"({kind})&made"
        if stars == 1 and base in ("char", "void"):
            return f"({kind})f->text" if "const" in kind else f"({kind})f->room"
        if stars == 1 and base.endswith("Id"):
            return f"({kind})f->room"
        if stars == 1 and base in self.structs or stars == 1 and base in self.enums:
            return f"FIX_{base}" if base in FIXED else (f"&def_{name}" if base in self.defaults else f"({kind})f->room")
        if stars == 1 and re.match(r"sw[A-Z]", base) and base not in self.structs:
            return f"f->{base[2].lower() + base[3:]}"  # an opaque object
        if stars == 1:
            return f"({kind})f->room"
        if base.startswith(("Vk", "PFN_")):
            return f"f->{base}" if base in VULKAN else f"({kind})0"
        if base in self.structs:
            return f"FIX_{base}" if base in FIXED else f"({base}){{0}}"
        if base in self.enums:
            return f"({base})0"
        if base in ("double", "float"):
            return f"({base})1"
        if base == "bool":
            return "false"
        if name == "size" and function == "swParseMeasuredSea":
            return "4"
        return f"({base})1" if name in ("width", "height", "frameIndex", "size", "count") else f"({base})0"

    def spoilt(self, kind, name):
        """Pairs of what is wrong and an expression; None needs the def to be changed first."""
        base = self.base(kind)
        stars = kind.count("*")
        out = []
        if stars > 0:
            if name not in OPTIONAL:
                out.append(("NULL", f"({kind})0"))
            if stars == 1 and (base in self.defaults or base == "swHost"):
                out.append(("zeroed", f"({kind})f->zeros"))
            return out
        if base.startswith(("Vk", "PFN_")) and not base.endswith(("Size", "Format")):
            return [("null", f"({kind})0")]
        if base in self.enums:
            return [("77", f"({base})77"), ("-1", f"({base})-1")]
        if base in ("double", "float"):
            return [("NaN", f"({base})NAN"), ("infinite", f"({base})INFINITY")]
        if base == "int":
            return [("-1", "-1")]
        if base.endswith("Id") and base in self.structs:
            return [("zero", f"({base}){{0}}"), ("stale", f"FIX_STALE_{base}")]
        if base in ("swPos", "swPosXZ", "swVec3", "swAngles"):
            return [("NaN", f"({base}){{NAN}}"), ("infinite", f"({base}){{INFINITY}}")]
        return out

    def fields(self, base, path=""):
        """Fields of a def that can be wrong, and how."""
        for kind, field in self.structs.get(base, []):
            if field == "internalValue":
                continue
            if kind in self.enums:
                yield path + field, "77", f"({kind})77"
            elif kind in ("double", "float"):
                yield path + field, "NaN", f"({kind})NAN"
                yield path + field, "infinite", f"({kind})INFINITY"
            elif kind in self.defaults:
                yield path + field, "zeroed", f"({kind}){{0}}"
                yield from self.fields(kind, path + field + ".")

    def is_allowed(self, function, argument, misuse):
        path = argument.split(".")
        names = [argument] + [".".join(path[i:]) for i in range(1, len(path))] + [".".join(path[:i]) + ".*" for i in
                                                                                  range(1, len(path))]
        for owner in (function, "*"):
            for key in [(owner, a, m) for a in names + ["*"] for m in (misuse, "*")]:
                if key in ALLOWED and key != ("*", "*", "*"):
                    self.used.add(key)
                    return True
        return False

    def add(self, function, index, misuse, expression, change=""):
        result, name, parameters = function
        argument = parameters[index][1] + (("." + change.split(" = ")[0].split(".", 1)[1]) if change else "")
        setup, arguments, made, hosts = "", [], False, False
        for i, (kind, parameter) in enumerate(parameters):
            base = self.base(kind)
            if base in self.defaults and kind.count("*") == 1 and base not in FIXED:
                setup += f"    {base} def_{parameter} = {self.defaults[base]}();\n"
            if base in self.defaults and kind.count("*") == 1 and base in FIXED:
                setup += f"    {base} def_{parameter} = *FIX_{base};\n"
            value = self.valid(kind, parameter, name)
            if base in self.structs and kind.count("*") == 1 and (base in self.defaults or base in COPIED):
                if base in COPIED:
                    setup += f"    {base} def_{parameter} = *FIX_{base};\n"
                value = f"&def_{parameter}"
            if i == index and not change:
                value = expression
            elif kind.count("*") == 2 and base.startswith("sw") and not kind.startswith("const"):
                made = True
            if (i != index or change) and kind.count("*") == 1 and (base == "swHost" or base in OBJECTS):
                hosts = True
            arguments.append(value)
        if change:
            setup += f"    {change} = {expression};\n"
        allowed = self.is_allowed(name, argument, misuse)
        call = f"{name}({', '.join(arguments)})"
        if name in FREES:
            return
        body = setup
        body += "    void* made = (void*)f;\n" if any("made" in a for a in arguments) else ""
        if result == "swResult":
            body += f"    swResult result = {call};\n"
            body += "" if allowed else "    CheckRefused(result);\n"
            body += "    CheckNull(made);\n" if made and not allowed else ""
        else:
            body += f"    (void){call};\n" if result != "void" else f"    {call};\n"
        body += "    CheckTold(f);\n" if hosts and not allowed else "    (void)f;\n"
        self.cases.append((f"{name}: {argument} is {misuse}", body))

    def write(self, path, is_gpu, is_scene):
        for function in self.functions:
            result, name, parameters = function
            for index, (kind, parameter) in enumerate(parameters):
                if name.startswith(("swDestroy",)) and kind.count("*") == 1 and len(parameters) == 1:
                    continue_null = True
                else:
                    continue_null = False
                for misuse, expression in self.spoilt(kind, parameter):
                    if continue_null and misuse == "NULL":
                        ALLOWED[(name, parameter, "NULL")] = "nothing to destroy"
                    self.add(function, index, misuse, expression)
                base = self.base(kind)
                if kind.count("*") == 1 and (base in self.defaults or base in COPIED):
                    for field, misuse, expression in self.fields(base):
                        self.add(function, index, misuse, expression, f"def_{parameter}.{field}")
        with open(path, "w", encoding="utf-8") as file:
            file.write("// SPDX-License-Identifier: MIT\n// Written by scripts/make_misuse_test.py; do not edit.\n")
            file.write(f"#define MISUSE_GPU {int(is_gpu)}\n#define MISUSE_SCENE {int(is_scene)}\n")
            file.write('#include "misuse/fixture.h"\n\n')
            for i, (text, body) in enumerate(self.cases):
                file.write(f"// {text}\nstatic void Case{i}(Fixture* f)\n{{\n{body}}}\n\n")
            file.write("static const Case cases[] = {\n")
            for i, (text, body) in enumerate(self.cases):
                file.write(f'    {{"{text}", Case{i}}},\n')
            file.write("};\n\nint main(void)\n{\n    return RunCases(cases, (int)(sizeof cases / sizeof cases[0]));\n}\n")
        stale = [key for key in ALLOWED if key not in self.used and key[0] in {f[1] for f in self.functions}]
        if stale:
            sys.exit(f"make_misuse_test.py: nothing is allowed by {stale}: mend the list")
        print(f"{len(self.functions)} functions, {len(self.cases)} misuses, {len(ALLOWED)} allowed")


# Types that the fixture has values of: FIX_<type> in tests/misuse/fixture.h.
FIXED = {"swHost", "swRasterDef", "swSplineDef", "swHullDef", "swMeshDef", "swFields", "swField", "swWaveSystemId", "swInputId", "swWaterBodyDef", "swWaterBodyId", "swFieldSamples", "swShot", "swSeaReplayDef", "swMeasuredSpectrumDef", "swSea", "swSceneSea",
         "swSurfaceSamples", "swVolumeSamples", "swHeightMapDef", "swScene", "swNdbcTexts", "swWaveSystemDef", "swSceneView",
         "swStageImage", "swStageBuffer", "swStageFrame", "swStageTargets", "swStageTerrainDef", "swSeaBins", "swSeaGauges"}
# Of those, what is copied and spoilt field by field although there is no default.
COPIED = {"swShot", "swHeightMapDef", "swSeaGauges"}
# Made with a host, which is told.
OBJECTS = {"swWorld", "swRaster", "swHull", "swMoment", "swView", "swGpu", "swGpuWorld", "swGpuQuery", "swRenderer", "swPicture", "swMeasuredSea",
           "swSeaReplay", "swScene", "swStage", "swStageTerrain", "swSeaPatches"}
VULKAN = {"VkCommandBuffer", "VkInstance", "VkPhysicalDevice", "VkImageView", "VkBuffer", "PFN_vkGetInstanceProcAddr"}
# Calls whose misuse nobody can tell: they take an address and give memory back.
FREES = set()


def main():
    folder, output = sys.argv[1:3]
    is_gpu, is_scene = "--gpu" in sys.argv, "--scene" in sys.argv
    names = HEADERS + (["gpu", "layers", "draw", "stage", "sheet", "lines"] if is_gpu else []) + (["files", "scene"] if is_scene else [])
    known = {name[:-2] for name in os.listdir(folder) if name.endswith(".h")} - {"seaway"}
    for name in known - set(HEADERS + ["gpu", "layers", "draw", "stage", "sheet", "lines", "files", "scene"]):
        sys.exit(f"make_misuse_test.py: {name}.h is in no list of headers here")
    Writer(*parse(folder, names)).write(output, is_gpu, is_scene)


if __name__ == "__main__":
    main()
