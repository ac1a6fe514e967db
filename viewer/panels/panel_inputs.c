// SPDX-License-Identifier: MIT
// What the scene puts into the sea: its inputs and bodies of water with their values, and the rasters, meshes, hulls
// and splines that they use.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "panels.h"

// ---- values ----

// What the numbers of a field are called, and what people turn them within.
typedef struct ValueKnobs
{
    const char* labels[4];
    float low, high;
    const char* format;
} ValueKnobs;

static const ValueKnobs valueKnobs[SW_INPUT_FIELD_COUNT] = {
    [SW_INPUT_FLOOR] = {{"height"}, -100.0f, 50.0f, "%.2f m"},
    [SW_INPUT_LEVEL] = {{"level"}, -20.0f, 20.0f, "%.2f m"},
    [SW_INPUT_FLOW] = {{"flow along x", "flow along z"}, -5.0f, 5.0f, "%.2f m/s"},
    [SW_INPUT_WAVES] = {{"weight of waves"}, 0.0f, 1.0f, "%.2f"},
    [SW_INPUT_DISPLACEMENT] = {{"moved along x", "moved upwards", "moved along z"}, -5.0f, 5.0f, "%.2f m"},
    [SW_INPUT_CLIP] = {{"no water above 0.5"}, 0.0f, 1.0f, "%.2f"},
    [SW_INPUT_FOAM] = {{"foam"}, 0.0f, 10.0f, "%.2f 1/s"},
    [SW_INPUT_ALBEDO] = {{"red", "green", "blue", "cover"}, 0.0f, 1.0f, "%.2f"},
    [SW_INPUT_WIND] = {{"wind along x", "wind along z"}, -30.0f, 30.0f, "%.1f m/s"},
    [SW_INPUT_SHADOW] = {{"light"}, 0.0f, 1.0f, "%.2f"},
    [SW_INPUT_BODY] = {{"number"}, 0.0f, 255.0f, "%.0f"},
};

static bool TurnInputValue(swInputDef* def, const swInputDef* filed)
{
    const ValueKnobs* knobs = &valueKnobs[def->field];
    bool hasChanged = false;
    for (int i = 0; i < swInputField_CountNumbers(def->field); i++)
    {
        float least = fminf(def->value[i], filed->value[i]), most = fmaxf(def->value[i], filed->value[i]);
        const Knob knob = {.label = knobs->labels[i],
                           .low = fminf(knobs->low, least),
                           .high = fmaxf(knobs->high, most),
                           .format = knobs->format};
        hasChanged |= TurnKnob(&knob, &def->value[i], &filed->value[i]);
    }
    return hasChanged;
}

// Whether a field of the table has an effect on this input, beyond what its shape says; and those that have a place of
// their own in the panel.
static bool IsShown(const swField* field, const swSceneInput* input)
{
    const swInputDef* def = &input->def;
    bool mayFollow =
        def->field == SW_INPUT_ALBEDO || def->field == SW_INPUT_FOAM || def->field == SW_INPUT_DISPLACEMENT;
    const struct
    {
        const char* member;
        bool isShown;
    } rules[] = {
        {"name", false},
        {"field", false},
        {"shape", false},
        {"value", false},
        {"order", input->nest == NULL},
        {"feather", input->nest == NULL},
        {"rotation", input->nest == NULL},
        {"followsWaves", mayFollow},
        {"wavelength", def->field == SW_INPUT_DISPLACEMENT},
        {"isBump", def->shape == SW_SHAPE_CIRCLE || def->shape == SW_SHAPE_PARTICLES},
        {"removesWaves", def->field == SW_INPUT_WAVES},
        {"alongSpline", def->field == SW_INPUT_WAVES},
        {"heading", def->field == SW_INPUT_WAVES},
    };
    for (size_t i = 0; i < sizeof(rules) / sizeof(rules[0]); i++)
    {
        if (strcmp(field->member, rules[i].member) == 0)
        {
            return rules[i].isShown && swFields_Counts(swGetInputFields(), field, def);
        }
    }
    return field->key != NULL && swFields_Counts(swGetInputFields(), field, def);
}

// ---- inputs ----

static const char* NameOf(const swField* choice, int index)
{
    return choice->names[index];
}

static const char* GetInputName(void* context, int index)
{
    static char text[160];
    const Sea* sea = context;
    const swInputDef* def = &sea->inputs[index].def;
    const swFields* fields = swGetInputFields();
    snprintf(text, sizeof(text), "%d %s%s%s, %s%s", index + 1, def->name, def->name[0] != '\0' ? ": " : "",
             NameOf(swFields_Find(fields, "field"), (int)def->field),
             NameOf(swFields_Find(fields, "shape"), (int)def->shape),
             CountInputChanges(&sea->inputs[index]) > 0 ? " *" : "");
    return text;
}

static void DrawInput(App* app, int index)
{
    Sea* sea = &app->sea;
    SeaInput* input = &sea->inputs[index];
    const swSceneInput* filed = &sea->scene->inputs[index];
    const swFields* fields = swGetInputFields();
    if (filed->isLeftOut)
    {
        UiFaint("Left out: its raster is a file that is not there");
        return;
    }
    if (filed->waves >= 0)
    {
        bool isGone = sea->waves[filed->waves].isRemoved;
        UiText("of waves %d%s", filed->waves + 1, isGone ? ", which were removed" : "");
    }
    bool hasChanged = TurnInputValue(&input->def, &input->filedDef);
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        hasChanged |= IsShown(field, filed) && TurnField(field, &input->def, &input->filedDef);
    }
    input->hasChanged = input->hasChanged || hasChanged;
    if (CountInputChanges(input) > 0 && UiButton("as in the file"))
    {
        input->def = input->filedDef;
        input->hasChanged = true;
    }
}

// ---- bodies of water ----

static const char* GetBodyName(void* context, int index)
{
    static char text[100];
    const Sea* sea = context;
    snprintf(text, sizeof(text), "%d %s%s", index + 1, sea->bodies[index].def.name,
             CountBodyChanges(&sea->bodies[index]) > 0 ? " *" : "");
    return text;
}

static void DrawBody(App* app, int index)
{
    SeaBody* body = &app->sea.bodies[index];
    const swFields* fields = swGetWaterBodyFields();
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        bool isShown = field->key != NULL && field->type < SW_FIELD_DEF && field->type != SW_FIELD_TEXT &&
                       strcmp(field->member, "look") != 0;
        body->hasChanged = (isShown && TurnField(field, &body->def, &body->filedDef)) || body->hasChanged;
    }
    int looks = app->sea.scene->lookCount;
    if (looks > 0)
    {
        body->hasChanged = TurnCount("look", &body->def.look, &body->filedDef.look, 0, looks, "%d") || body->hasChanged;
    }
}

// ---- resources ----

static void DrawRasters(const swScene* scene)
{
    static const UiColumn columns[] = {{"raster", 0.0f}, {"cells", 10.0f}, {"m apart", 7.0f}, {"least, most", 12.0f}};
    if (scene->rasterCount == 0 || !BeginUiTable("rasters", 4, columns))
    {
        return;
    }
    for (int i = 0; i < scene->rasterCount; i++)
    {
        const swSceneRaster* raster = &scene->rasters[i];
        UiCell("%s", raster->name);
        if (raster->raster == NULL)
        {
            UiCell("missing");
            UiCell("-");
            UiCell("-");
            continue;
        }
        swRasterInfo info = swRaster_GetInfo(raster->raster);
        UiCell("%d x %d", info.width, info.height);
        UiCell("%.4g", info.spacingX);
        UiCell("%.4g, %.4g", (double)info.least, (double)info.most);
    }
    EndUiTable();
}

static void DrawLines(const swScene* scene)
{
    static const UiColumn columns[] = {{"spline", 0.0f}, {"points", 7.0f}, {"m long", 8.0f}};
    if (scene->splineCount == 0 || !BeginUiTable("splines", 3, columns))
    {
        return;
    }
    for (int i = 0; i < scene->splineCount; i++)
    {
        const swSceneSpline* spline = &scene->splines[i];
        UiCell("%s", spline->name);
        UiCell("%d", spline->pointCount);
        UiCell(spline->spline != NULL ? "%.5g" : "-",
               spline->spline != NULL ? swSpline_GetInfo(spline->spline).length : 0.0);
    }
    EndUiTable();
}

static void DrawMeshes(const swScene* scene)
{
    static const UiColumn columns[] = {{"mesh, hull", 0.0f}, {"file", 0.0f}, {"triangles", 9.0f}};
    if (scene->meshCount + scene->hullCount == 0 || !BeginUiTable("meshes", 3, columns))
    {
        return;
    }
    for (int i = 0; i < scene->meshCount; i++)
    {
        const swSceneMesh* mesh = &scene->meshes[i];
        UiCell("%s", mesh->name);
        UiCell("%s", mesh->file);
        UiCell("%d", mesh->mesh != NULL ? swMesh_GetInfo(mesh->mesh).triangleCount : 0);
    }
    for (int i = 0; i < scene->hullCount; i++)
    {
        UiCell("%s", scene->hulls[i].name);
        UiCell("%s", scene->hulls[i].file);
        UiCell("hull");
    }
    EndUiTable();
}

static int Clamp(int index, int count)
{
    return index < count ? index : count - 1;
}

void DrawInputPanel(App* app)
{
    Sea* sea = &app->sea;
    const swScene* scene = sea->scene;
    if (scene == NULL)
    {
        return;
    }
    if (scene->inputCount > 0 && BeginUiSection("Inputs", false))
    {
        app->chosenInput = Clamp(app->chosenInput, scene->inputCount);
        UiChoice("input", &app->chosenInput, scene->inputCount, GetInputName, sea);
        PushUiScope(app->chosenInput);
        DrawInput(app, app->chosenInput);
        PopUiScope();
    }
    if (scene->waterBodyCount > 0 && BeginUiSection("Bodies of water", false))
    {
        app->chosenBody = Clamp(app->chosenBody, scene->waterBodyCount);
        UiChoice("body", &app->chosenBody, scene->waterBodyCount, GetBodyName, sea);
        PushUiScope(app->chosenBody);
        DrawBody(app, app->chosenBody);
        PopUiScope();
    }
    if (scene->rasterCount + scene->splineCount + scene->meshCount + scene->hullCount > 0 &&
        BeginUiSection("Rasters, meshes, splines", false))
    {
        DrawRasters(scene);
        DrawMeshes(scene);
        DrawLines(scene);
    }
}
