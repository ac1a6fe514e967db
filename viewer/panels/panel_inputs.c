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
static bool IsShown(const swField* field, const SeaInput* input, bool isNest)
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
        {"order", !isNest},
        {"feather", !isNest},
        {"rotation", !isNest},
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

// ---- what and where ----

static const char* GetFieldName(void* context, int index)
{
    (void)context;
    return NameOf(swFields_Find(swGetInputFields(), "field"), index);
}

static const char* GetShapeName(void* context, int index)
{
    const int* shapes = context;
    return NameOf(swFields_Find(swGetInputFields(), "shape"), shapes[index]);
}

static bool TurnInputField(SeaInput* input)
{
    int field = (int)input->def.field, filed = (int)input->filedDef.field;
    bool hasChanged = TurnChoice("says", &field, &filed, SW_INPUT_FIELD_COUNT, GetFieldName, NULL);
    if (hasChanged && field == filed)
    {
        memcpy(input->def.value, input->filedDef.value, sizeof(input->def.value));
    }
    if (hasChanged)
    {
        ChangeInputField(input, (swInputField)field);
    }
    return hasChanged;
}

// Shapes that need a file, a spline or a function cannot be chosen, and stay where the file has them.
static bool TurnInputShape(App* app, SeaInput* input)
{
    int shapes[SW_SHAPE_COUNT], count = 0, chosen = 0, filed = 0;
    for (int i = 0; i < SW_SHAPE_COUNT; i++)
    {
        if (IsShapeFree(input, (swInputShape)i))
        {
            chosen = i == (int)input->def.shape ? count : chosen;
            filed = i == (int)input->filedDef.shape ? count : filed;
            shapes[count++] = i;
        }
    }
    bool hasChanged = TurnChoice("shape", &chosen, &filed, count, GetShapeName, shapes);
    if (hasChanged && !ChangeInputShape(input, (swInputShape)shapes[chosen]))
    {
        ShowNote(app, "there is no memory for its points");
    }
    return hasChanged;
}

// ---- tides ----

static const char* GetTideName(void* context, int index)
{
    (void)context;
    return swGetTideName(index);
}

static int CountTideNames(void)
{
    int count = 0;
    while (swGetTideName(count) != NULL)
    {
        count++;
    }
    return count;
}

static bool TurnConstituent(swTideConstituent* tide, const swTideConstituent* filed, bool isFlow)
{
    static const char* const members[] = {"amplitude", "phase", "amplitudeAcross", "phaseAcross"};
    int count = CountTideNames(), name = 0;
    while (name < count && swGetTideSpeed(swGetTideName(name)) != tide->speed)
    {
        name++;
    }
    bool hasChanged = false;
    if (name < count && UiChoice("constituent", &name, count, GetTideName, NULL))
    {
        tide->speed = swGetTideSpeed(swGetTideName(name));
        hasChanged = true;
    }
    for (int i = 0; i < (isFlow ? 4 : 2); i++)
    {
        hasChanged |= TurnMember(swGetTideFields(), members[i], tide, filed->speed > 0.0f ? filed : NULL);
    }
    return hasChanged;
}

// The constituents of a level or a flow; a table stays the file's.
static bool DrawTide(swTideConstituent tide[SW_MAX_TIDE], const swTideConstituent filed[SW_MAX_TIDE], bool isFlow,
                     int tableCount)
{
    bool hasChanged = false;
    int count = CountTide(tide), gone = -1;
    if (!BeginUiGroup("Tide", false))
    {
        return false;
    }
    if (tableCount > 0)
    {
        UiFaint("by a table of %d lines", tableCount);
        return false;
    }
    for (int i = 0; i < count; i++)
    {
        PushUiScope(i);
        hasChanged |= TurnConstituent(&tide[i], &filed[i], isFlow);
        gone = UiSmallButton("take it away") ? i : gone;
        PopUiScope();
    }
    if (gone >= 0)
    {
        RemoveConstituent(tide, gone);
    }
    bool isMore = count < SW_MAX_TIDE && UiSmallButton("another constituent");
    if (isMore)
    {
        AddConstituent(tide);
    }
    return hasChanged || gone >= 0 || isMore;
}

static bool DrawInputTide(SeaInput* input, const swSceneInput* scene)
{
    bool isFlow = input->def.field == SW_INPUT_FLOW;
    return (isFlow || input->def.field == SW_INPUT_LEVEL) &&
           DrawTide(input->def.tide, input->filedDef.tide, isFlow, scene->tide.count);
}

// ---- points ----

// One number of a point; its knob turns about where the file has it.
static bool TurnPlace(const char* member, const char* label, float* value, const float* filed)
{
    swField knob = *swFields_Find(swGetInputPointFields(), member);
    float middle = filed != NULL ? *filed : 0.0f;
    knob.knobLow = fmax(knob.low, (double)fminf(*value, middle) - 25.0);
    knob.knobHigh = (double)fmaxf(*value, middle) + 25.0;
    UiNextCell();
    return TurnValue(&knob, label, value, filed);
}

// What the buttons behind a point ask for: 1 another one, -1 this one away.
static int DrawPointButtons(void)
{
    UiNextCell();
    int wish = UiSmallButton("+") ? 1 : 0;
    UiTip("Another point, half way to the next one");
    UiSameLine();
    wish = UiSmallButton("-") ? -1 : wish;
    UiTip("Take this point away");
    return wish;
}

typedef bool DrawRowFcn(void* context, int row);

// What the buttons of a table of points asked for: 1 another one behind a row, -1 that row away.
typedef struct PointWish
{
    int wish, row;
} PointWish;

static PointWish DrawPointTable(bool hasRadius, int count, DrawRowFcn* drawRow, void* context, bool* hasChanged)
{
    static const UiColumn columns[] = {{"x, m", 0.0f}, {"z, m", 0.0f}, {"radius", 0.0f}, {"", 6.0f}};
    static const UiColumn corners[] = {{"x, m", 0.0f}, {"z, m", 0.0f}, {"", 6.0f}};
    PointWish wish = {0};
    int first = 0, end = 0;
    if (!BeginUiTable("points", hasRadius ? 4 : 3, hasRadius ? columns : corners))
    {
        return wish;
    }
    BeginUiRows(count);
    while (StepUiRows(&first, &end))
    {
        for (int i = first; i < end; i++)
        {
            PushUiScope(i);
            *hasChanged |= drawRow(context, i);
            int asked = DrawPointButtons();
            PopUiScope();
            wish = asked != 0 ? (PointWish){asked, i} : wish;
        }
    }
    EndUiTable();
    return wish;
}

static bool DrawInputPoint(void* context, int row)
{
    SeaInput* input = context;
    bool isFiled = row < input->filedDef.pointCount;
    swInputPoint* point = &input->points[row];
    const swInputPoint* filed = isFiled ? &input->filedDef.points[row] : NULL;
    bool hasChanged = TurnPlace("x", "##x", &point->x, isFiled ? &filed->x : NULL);
    hasChanged |= TurnPlace("z", "##z", &point->z, isFiled ? &filed->z : NULL);
    if (input->def.shape != SW_SHAPE_POLYGON)
    {
        hasChanged |= TurnPlace("radius", "##radius", &point->radius, isFiled ? &filed->radius : NULL);
    }
    return hasChanged;
}

static bool DrawInputPoints(SeaInput* input)
{
    bool hasChanged = false;
    if (!HasPoints(input->def.shape) || !BeginUiGroup("Points", false))
    {
        return false;
    }
    PointWish wish =
        DrawPointTable(input->def.shape != SW_SHAPE_POLYGON, input->pointCount, DrawInputPoint, input, &hasChanged);
    if (wish.wish > 0)
    {
        AddInputPoint(input, wish.row);
    }
    if (wish.wish < 0)
    {
        RemoveInputPoint(input, wish.row);
    }
    return hasChanged;
}

static bool DrawShorePoint(void* context, int row)
{
    SeaBody* body = context;
    const swVec2* filed = row < body->filedDef.pointCount ? &body->filedDef.points[row] : NULL;
    bool hasChanged = TurnPlace("x", "##x", &body->points[row].x, filed != NULL ? &filed->x : NULL);
    return TurnPlace("z", "##z", &body->points[row].y, filed != NULL ? &filed->y : NULL) || hasChanged;
}

static bool DrawShore(SeaBody* body)
{
    bool hasChanged = false;
    if (!BeginUiGroup("Shore", false))
    {
        return false;
    }
    PointWish wish = DrawPointTable(false, body->pointCount, DrawShorePoint, body, &hasChanged);
    if (wish.wish > 0)
    {
        AddShorePoint(body, wish.row);
    }
    if (wish.wish < 0)
    {
        RemoveShorePoint(body, wish.row);
    }
    return hasChanged;
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
    if (input->isRemoved)
    {
        UiFaint("Taken away");
        if (UiButton("bring back"))
        {
            BringBackInput(sea, index);
        }
        return;
    }
    if (swSceneInput_IsMoving(filed))
    {
        UiFaint("Moves by itself; its place and turn are those with which it sets out");
    }
    bool isNest = filed->nest != NULL;
    if (!isNest && (TurnInputField(input) || TurnInputShape(app, input)))
    {
        return; // the rest is of the new one, in the next frame
    }
    bool hasChanged = TurnInputValue(&input->def, &input->filedDef);
    for (int i = 0; i < fields->count; i++)
    {
        const swField* field = &fields->fields[i];
        hasChanged |= IsShown(field, input, isNest) && TurnField(field, &input->def, &input->filedDef);
    }
    hasChanged |= DrawInputTide(input, filed);
    hasChanged |= DrawInputPoints(input);
    input->hasChanged = input->hasChanged || hasChanged;
    if (UiButton("take it away"))
    {
        RemoveInput(sea, index);
        return;
    }
    UiSameLine();
    if (!input->isAdded && CountInputChanges(input) > 0 && UiButton("as in the file"))
    {
        ResetInput(sea, index);
    }
}

// A field to choose, and a button that puts a circle of it where the camera looks.
static void DrawNewInput(App* app)
{
    UiChoice("of the field", &app->newField, SW_INPUT_BODY, GetFieldName, NULL);
    if (UiButton("another input"))
    {
        swPosXZ origin = swWorld_GetOrigin(app->sea.world);
        double ahead = 60.0, heading = (double)app->camera.heading;
        const swPos place = {app->camera.position.x + origin.x + ahead * sin(heading), 0.0,
                             app->camera.position.z + origin.z - ahead * cos(heading)};
        bool isAdded = AddInput(&app->sea, (swInputField)app->newField, place);
        app->chosenInput = isAdded ? app->sea.scene->inputCount - 1 : app->chosenInput;
    }
    UiTip("A circle of 100 m, 60 m ahead of the camera");
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
    PushUiScope(-1);
    body->hasChanged =
        DrawTide(body->def.tide, body->filedDef.tide, false, app->sea.scene->waterBodies[index].tide.count) ||
        body->hasChanged;
    body->hasChanged = DrawShore(body) || body->hasChanged;
    PopUiScope();
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
    if (BeginUiSection("Inputs", false))
    {
        if (scene->inputCount > 0)
        {
            app->chosenInput = Clamp(app->chosenInput, scene->inputCount);
            UiChoice("input", &app->chosenInput, scene->inputCount, GetInputName, sea);
            PushUiScope(app->chosenInput);
            DrawInput(app, app->chosenInput);
            PopUiScope();
            UiSpace();
        }
        DrawNewInput(app);
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
