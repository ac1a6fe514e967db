// SPDX-License-Identifier: MIT
// The panel's widgets by Dear ImGui, whose context and window backend live here. What it wants drawn is handed on as
// plain arrays; ui_draw.c says why its own Vulkan backend is left out.

extern "C"
{
#include "input_queue.h"
#include "ui.h"
#include "ui_scale.h"
}

#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

static_assert(sizeof(UiVertex) == sizeof(ImDrawVert), "a vertex is copied as it is");
static_assert(offsetof(UiVertex, uv) == offsetof(ImDrawVert, uv), "a vertex is copied as it is");
static_assert(offsetof(UiVertex, color) == offsetof(ImDrawVert, col), "a vertex is copied as it is");
static_assert(sizeof(ImDrawIdx) == sizeof(uint16_t), "an index is copied as it is");

static const ImVec4 faintColor(0.62f, 0.70f, 0.75f, 1.0f);
static const ImVec4 warningColor(1.0f, 0.72f, 0.35f, 1.0f);
static const ImVec4 changedColor(1.0f, 0.82f, 0.45f, 1.0f);
static const ImVec4 handleColor(0.31f, 0.67f, 0.78f, 1.0f);
static const ImVec4 activeHandleColor(0.45f, 0.83f, 0.93f, 1.0f);

// Letters are drawn at sizes of their own instead of being stretched; 13 and its multiples are the sharpest.
static const int fontSizes[] = {10, 11, 12, 13, 14, 16, 18, 20, 23, 26, 30, 34, 39, 46, 52};
static const int fontCount = sizeof(fontSizes) / sizeof(fontSizes[0]);

static struct
{
    float density; // pixels of the picture in one of the window's units
    float scale;   // of letters and spaces
    ImVec2 room;   // the window, when the panel was placed
    float panelRight;
    bool mustPlace; // the panel, with its next frame
    ImVec2 cursor;  // where a button was pressed in this frame's events
    bool hasCursor; //
    bool isMarked;  // the next widget differs from the file
    bool hasSlot;   // the next widget can differ from a file
    char markTip[160];
    bool wasReset;  // the last widget's mark was clicked
    bool isHovered; // the last widget or its label
} ui;

static void SetStyle(float scale)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.WindowRounding = 4.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.FramePadding = ImVec2(4.0f, 4.0f);
    style.ItemSpacing = ImVec2(8.0f, 3.0f);
    style.ScrollbarSize = 12.0f;
    style.WindowBorderSize = 0.0f;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.05f, 0.08f, 0.10f, 0.84f);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.06f, 0.11f, 0.14f, 1.0f);
    style.Colors[ImGuiCol_TitleBg] = ImVec4(0.06f, 0.17f, 0.22f, 0.95f);
    style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.07f, 0.24f, 0.31f, 0.95f);
    style.Colors[ImGuiCol_Header] = ImVec4(0.10f, 0.30f, 0.38f, 0.75f);
    style.Colors[ImGuiCol_HeaderHovered] = ImVec4(0.14f, 0.40f, 0.50f, 0.85f);
    style.Colors[ImGuiCol_HeaderActive] = ImVec4(0.16f, 0.46f, 0.57f, 1.0f);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.17f, 0.25f, 0.29f, 0.90f);
    style.Colors[ImGuiCol_FrameBgHovered] = ImVec4(0.17f, 0.30f, 0.36f, 0.80f);
    style.Colors[ImGuiCol_FrameBgActive] = ImVec4(0.19f, 0.37f, 0.44f, 0.90f);
    style.Colors[ImGuiCol_CheckMark] = activeHandleColor;
    style.Colors[ImGuiCol_Button] = ImVec4(0.12f, 0.33f, 0.41f, 0.80f);
    style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.16f, 0.46f, 0.57f, 1.0f);
    style.Colors[ImGuiCol_TableHeaderBg] = ImVec4(0.08f, 0.17f, 0.21f, 1.0f);
    style.Colors[ImGuiCol_PlotHistogram] = ImVec4(0.13f, 0.40f, 0.50f, 1.0f);
    style.Colors[ImGuiCol_PlotLines] = activeHandleColor;
    style.ScaleAllSizes(scale);
}

void SetUiScale(float scale)
{
    ImGuiIO& io = ImGui::GetIO();
    float wanted = 13.0f * scale * ui.density;
    int best = 0;
    for (int i = 1; i < fontCount; i++)
    {
        float a = static_cast<float>(fontSizes[best]), b = static_cast<float>(fontSizes[i]);
        best = std::fabs(b - wanted) < std::fabs(a - wanted) ? i : best;
    }
    float nearest = static_cast<float>(fontSizes[best]) / (13.0f * ui.density);
    if (nearest != ui.scale)
    {
        ui.scale = nearest;
        io.FontDefault = io.Fonts->Fonts[best];
        io.FontGlobalScale = 1.0f / ui.density;
        SetStyle(nearest);
        ui.mustPlace = true;
    }
}

static float GetDensity(GLFWwindow* window)
{
    int width = 0, height = 0, pixelWidth = 0, pixelHeight = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
    return width > 0 && pixelWidth > 0 ? static_cast<float>(pixelWidth) / static_cast<float>(width) : 1.0f;
}

bool OpenUi(GLFWwindow* window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.BackendRendererName = "seaway";
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    for (int size : fontSizes)
    {
        ImFontConfig config;
        config.SizePixels = static_cast<float>(size);
        config.OversampleH = config.OversampleV = size % 13 == 0 ? 1 : 2;
        config.PixelSnapH = true;
        io.Fonts->AddFontDefault(&config);
    }
    ui.density = GetDensity(window);
    ui.scale = 0.0f;
    SetUiScale(1.0f);
    return ImGui_ImplGlfw_InitForVulkan(window, false);
}

float GetUiDensity(GLFWwindow* window)
{
    float scaleX = 1.0f, scaleY = 1.0f;
    glfwGetWindowContentScale(window, &scaleX, &scaleY);
    return scaleX / GetDensity(window);
}

void CloseUi(void)
{
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

const uint8_t* GetUiAtlas(int* width, int* height)
{
    unsigned char* pixels = nullptr;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, width, height);
    return pixels;
}

bool HasUiMouse(void)
{
    return ImGui::GetIO().WantCaptureMouse;
}

bool HasUiKeyboard(void)
{
    return ImGui::GetIO().WantTextInput || ImGui::IsAnyItemActive();
}

void FeedUi(GLFWwindow* window, const InputEvent* event)
{
    switch (event->kind)
    {
    case INPUT_KEY:
        ImGui_ImplGlfw_KeyCallback(window, event->code, event->scancode, event->action, event->modifiers);
        break;
    case INPUT_LETTER:
        ImGui_ImplGlfw_CharCallback(window, static_cast<unsigned>(event->code));
        break;
    case INPUT_BUTTON:
        ImGui_ImplGlfw_MouseButtonCallback(window, event->code, event->action, event->modifiers);
        ui.cursor = ImVec2(static_cast<float>(event->x), static_cast<float>(event->y));
        ui.hasCursor = true;
        break;
    case INPUT_WHEEL:
        ImGui_ImplGlfw_ScrollCallback(window, event->x, event->y);
        break;
    }
}

void FeedUiFocus(GLFWwindow* window, bool isFocused)
{
    ImGui_ImplGlfw_WindowFocusCallback(window, isFocused);
}

void FeedUiEntry(GLFWwindow* window, bool isInside)
{
    ImGui_ImplGlfw_CursorEnterCallback(window, isInside);
}

void BeginUiFrame(void)
{
    ImGui_ImplGlfw_NewFrame();
    if (ui.hasCursor) // the cursor has moved on since, in a slow frame
    {
        ImGui::GetIO().MousePos = ui.cursor;
        ui.hasCursor = false;
    }
    ImGui::NewFrame();
}

static void AddCommand(UiMesh* mesh, const ImDrawData* data, const ImDrawCmd& from, uint32_t firstIndex,
                       uint32_t firstVertex)
{
    if (from.UserCallback != nullptr || mesh->commandCount == MAX_UI_COMMANDS)
    {
        return;
    }
    UiCommand* command = &mesh->commands[mesh->commandCount++];
    command->clip[0] = (from.ClipRect.x - data->DisplayPos.x) * data->FramebufferScale.x;
    command->clip[1] = (from.ClipRect.y - data->DisplayPos.y) * data->FramebufferScale.y;
    command->clip[2] = (from.ClipRect.z - data->DisplayPos.x) * data->FramebufferScale.x;
    command->clip[3] = (from.ClipRect.w - data->DisplayPos.y) * data->FramebufferScale.y;
    command->indexCount = from.ElemCount;
    command->firstIndex = firstIndex + from.IdxOffset;
    command->vertexOffset = static_cast<int32_t>(firstVertex + from.VtxOffset);
}

void EndUiFrame(UiMesh* mesh)
{
    ImGui::Render();
    const ImDrawData* data = ImGui::GetDrawData();
    mesh->width = data->DisplaySize.x;
    mesh->height = data->DisplaySize.y;
    mesh->vertexCount = 0;
    mesh->indexCount = 0;
    mesh->commandCount = 0;
    for (int i = 0; i < data->CmdListsCount; i++)
    {
        const ImDrawList* list = data->CmdLists[i];
        for (const ImDrawCmd& command : list->CmdBuffer)
        {
            AddCommand(mesh, data, command, mesh->indexCount, mesh->vertexCount);
        }
        mesh->vertexCount += static_cast<uint32_t>(list->VtxBuffer.Size);
        mesh->indexCount += static_cast<uint32_t>(list->IdxBuffer.Size);
    }
}

void CopyUiMesh(UiVertex* vertices, uint16_t* indices)
{
    const ImDrawData* data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; i++)
    {
        const ImDrawList* list = data->CmdLists[i];
        memcpy(vertices, list->VtxBuffer.Data, static_cast<size_t>(list->VtxBuffer.size_in_bytes()));
        memcpy(indices, list->IdxBuffer.Data, static_cast<size_t>(list->IdxBuffer.size_in_bytes()));
        vertices += list->VtxBuffer.Size;
        indices += list->IdxBuffer.Size;
    }
}

void BeginUiPanel(const char* title)
{
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImVec2 room = viewport->WorkSize;
    bool mustPlace = ui.mustPlace || room.x != ui.room.x || room.y != ui.room.y;
    ImGuiCond when = mustPlace ? ImGuiCond_Always : ImGuiCond_FirstUseEver;
    float margin = std::fmin(10.0f, 0.01f * room.x);
    ui.room = room;
    ui.mustPlace = false;
    ImGui::SetNextWindowPos(ImVec2(margin, margin), when);
    ImGui::SetNextWindowSize(ImVec2(ChoosePanelWidth(room.x, ImGui::GetFontSize()), room.y - 2.0f * margin), when);
    ImGui::Begin(title, nullptr, ImGuiWindowFlags_NoFocusOnAppearing);
    ui.panelRight = ImGui::IsWindowCollapsed() ? 0.0f : ImGui::GetWindowPos().x + ImGui::GetWindowWidth();
    ImGui::PushItemWidth(std::fmin(13.0f * ImGui::GetFontSize(), 0.5f * ImGui::GetContentRegionAvail().x));
}

float GetUiPanelRight(void)
{
    return ui.panelRight;
}

void EndUiPanel(void)
{
    ImGui::PopItemWidth();
    ImGui::End();
}

void ShowUiNote(const char* text)
{
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImVec2 place(viewport->WorkPos.x + viewport->WorkSize.x * 0.5f, viewport->WorkPos.y + viewport->WorkSize.y - 24.0f);
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, ImVec2(0.5f, 1.0f));
    ImGui::Begin("note", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    ImGui::TextUnformatted(text);
    ImGui::End();
}

int AskUiQuestion(const char* text, const char* yes, const char* no)
{
    const ImGuiViewport* viewport = ImGui::GetMainViewport();
    ImVec2 place(viewport->WorkPos.x + viewport->WorkSize.x * 0.5f, viewport->WorkPos.y + viewport->WorkSize.y * 0.5f);
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetFontSize(), ImGui::GetFontSize()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.06f, 0.15f, 0.19f, 0.97f));
    ImGui::PushStyleColor(ImGuiCol_Border, changedColor);
    ImGui::Begin("question", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoNav);
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    ImGui::PushTextWrapPos(std::fmin(30.0f * ImGui::GetFontSize(), viewport->WorkSize.x - 40.0f));
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    ImGui::Spacing();
    int answer = ImGui::Button(yes) ? 1 : 0;
    ImGui::SameLine();
    answer = ImGui::Button(no) ? -1 : answer;
    ImGui::End();
    return answer;
}

bool BeginUiSection(const char* label, bool isOpen)
{
    return ImGui::CollapsingHeader(label, isOpen ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
}

bool BeginUiGroup(const char* label, bool isOpen)
{
    ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth;
    return ImGui::TreeNodeEx(label, isOpen ? flags | ImGuiTreeNodeFlags_DefaultOpen : flags);
}

void PushUiScope(int id)
{
    ImGui::PushID(id);
}

void PopUiScope(void)
{
    ImGui::PopID();
}

void UiText(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextV(format, arguments);
    va_end(arguments);
}

void UiWrapped(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextWrappedV(format, arguments);
    va_end(arguments);
}

void UiFaint(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::PushStyleColor(ImGuiCol_Text, faintColor);
    ImGui::TextWrappedV(format, arguments);
    ImGui::PopStyleColor();
    ui.isHovered = ImGui::IsItemHovered();
    va_end(arguments);
}

void UiMarked(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextColoredV(changedColor, format, arguments);
    ui.isHovered = ImGui::IsItemHovered();
    va_end(arguments);
}

void UiWarning(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::PushStyleColor(ImGuiCol_Text, warningColor);
    ImGui::TextWrappedV(format, arguments);
    ImGui::PopStyleColor();
    va_end(arguments);
}

void UiTip(const char* text)
{
    if (ui.isHovered)
    {
        ImGui::SetTooltip("%s", text);
    }
}

void UiSpace(void)
{
    ImGui::Spacing();
}

void UiSameLine(void)
{
    ImGui::SameLine();
}

bool UiButton(const char* label)
{
    bool isPressed = ImGui::Button(label);
    ui.isHovered = ImGui::IsItemHovered();
    return isPressed;
}

bool UiSmallButton(const char* label)
{
    bool isPressed = ImGui::SmallButton(label);
    ui.isHovered = ImGui::IsItemHovered();
    return isPressed;
}

void UiMarkNext(bool isChanged, const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(ui.markTip, sizeof(ui.markTip), format, arguments);
    va_end(arguments);
    ui.isMarked = isChanged;
    ui.hasSlot = true;
}

bool UiWasReset(void)
{
    return ui.wasReset;
}

static float GetSlotWidth(void)
{
    return std::floor(0.9f * ImGui::GetFontSize());
}

// The mark of a value that differs from the file's: a dot to click, in a slot that is there also without.
static void DrawMark(const char* label)
{
    ImVec2 size(GetSlotWidth(), ImGui::GetFrameHeight());
    ui.wasReset = false;
    ImGui::SameLine(0.0f, 0.0f);
    if (!ui.isMarked)
    {
        ImGui::Dummy(size);
        return;
    }
    ImVec2 place = ImGui::GetCursorScreenPos();
    ImGui::PushID(label);
    ui.wasReset = ImGui::InvisibleButton("reset", size);
    bool isHovered = ImGui::IsItemHovered();
    ImGui::PopID();
    float radius = ImGui::GetFontSize() * (isHovered ? 0.30f : 0.20f);
    ImGui::GetWindowDrawList()->AddCircleFilled(ImVec2(place.x + 0.5f * size.x, place.y + 0.5f * size.y), radius,
                                                ImGui::GetColorU32(changedColor));
    if (isHovered)
    {
        ImGui::SetTooltip("%s", ui.markTip);
    }
}

// Where a widget's own frame goes: in a cell of a table all of it but the mark's slot.
static void BeginWidget(const char* label)
{
    if (label[0] == '#' && ui.hasSlot)
    {
        ImGui::SetNextItemWidth(-GetSlotWidth());
    }
    ImGui::PushID(label);
}

// Mark and label behind the frame that was just drawn.
static void EndWidget(const char* label)
{
    ImGui::PopID();
    ui.isHovered = ImGui::IsItemHovered();
    ui.wasReset = false;
    bool hasLabel = label[0] != '#';
    if (hasLabel || ui.hasSlot)
    {
        DrawMark(label);
    }
    if (hasLabel)
    {
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::AlignTextToFramePadding();
        ImGui::PushStyleColor(ImGuiCol_Text, ui.isMarked ? changedColor : ImGui::GetStyleColorVec4(ImGuiCol_Text));
        ImGui::TextUnformatted(label);
        ImGui::PopStyleColor();
        ui.isHovered |= ImGui::IsItemHovered();
    }
    ui.isMarked = ui.hasSlot = false;
}

bool UiCheckbox(const char* label, bool* value)
{
    bool isMarked = ui.isMarked, hasSlot = ui.hasSlot;
    ImGui::PushStyleColor(ImGuiCol_Text, isMarked ? changedColor : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    bool hasChanged = ImGui::Checkbox(label, value);
    ImGui::PopStyleColor();
    ui.isHovered = ImGui::IsItemHovered();
    ui.wasReset = false;
    if (hasSlot)
    {
        DrawMark(label);
    }
    ui.isMarked = ui.hasSlot = false;
    return hasChanged;
}

// A slider whose handle runs on a line below its value, which it never covers.
static bool Slider(const char* label, ImGuiDataType type, void* value, const void* low, const void* high, double place,
                   const char* format, ImGuiSliderFlags flags)
{
    BeginWidget(label);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, 0);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, 0);
    bool hasChanged =
        ImGui::SliderScalar("##slider", type, value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleColor(2);
    bool isActive = ImGui::IsItemActive();
    ImVec2 end = ImGui::GetItemRectMax();
    float line = 2.0f * ui.scale, half = 3.0f * ui.scale;
    float left = corner.x + 2.0f + half, right = end.x - 2.0f - half;
    float x = left + static_cast<float>(place) * (right - left);
    ImU32 color = ImGui::GetColorU32(isActive ? activeHandleColor : handleColor);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(ImVec2(corner.x + 2.0f, end.y - line), ImVec2(x, end.y), color, line);
    list->AddRectFilled(ImVec2(x - half, end.y - 2.0f * line), ImVec2(x + half, end.y), color, line);
    EndWidget(label);
    return hasChanged;
}

bool UiSlider(const char* label, float* value, float low, float high, const char* format)
{
    double place =
        FindSliderPlace(static_cast<double>(*value), static_cast<double>(low), static_cast<double>(high), false);
    return Slider(label, ImGuiDataType_Float, value, &low, &high, place, format, 0);
}

bool UiLogSlider(const char* label, float* value, float low, float high, const char* format)
{
    double place =
        FindSliderPlace(static_cast<double>(*value), static_cast<double>(low), static_cast<double>(high), true);
    return Slider(label, ImGuiDataType_Float, value, &low, &high, place, format, ImGuiSliderFlags_Logarithmic);
}

bool UiSliderInt(const char* label, int* value, int low, int high, const char* format)
{
    double place = FindSliderPlace(*value, low, high, false);
    return Slider(label, ImGuiDataType_S32, value, &low, &high, place, format, 0);
}

bool UiDoubleSlider(const char* label, double* value, double low, double high, const char* format)
{
    double place = FindSliderPlace(*value, low, high, false);
    return Slider(label, ImGuiDataType_Double, value, &low, &high, place, format, 0);
}

bool UiColor(const char* label, swVec3* rgb)
{
    BeginWidget(label);
    bool hasChanged = ImGui::ColorEdit3("##color", &rgb->x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
    EndWidget(label);
    return hasChanged;
}

static bool ChooseItem(int item, int* index, const char* name)
{
    ImGui::PushID(item);
    bool isChosen = ImGui::Selectable(name, item == *index);
    if (item == *index)
    {
        ImGui::SetItemDefaultFocus();
    }
    ImGui::PopID();
    bool hasChanged = isChosen && item != *index;
    *index = isChosen ? item : *index;
    return hasChanged;
}

// Lists may be as long as a year of records; only what is seen is made.
static bool Choose(int* index, int count, UiItemFcn getName, void* context)
{
    bool hasChanged = false;
    ImGuiListClipper clipper;
    clipper.Begin(count);
#if IMGUI_VERSION_NUM >= 18990 // another name for the same: the chosen one, which the list opens at
    clipper.IncludeItemByIndex(*index);
#else
    clipper.ForceDisplayRangeByIndices(*index, *index + 1);
#endif
    while (clipper.Step())
    {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; i++)
        {
            hasChanged |= ChooseItem(i, index, getName(context, i));
        }
    }
    return hasChanged;
}

bool UiChoice(const char* label, int* index, int count, UiItemFcn getName, void* context)
{
    bool hasChanged = false;
    BeginWidget(label);
    if (ImGui::BeginCombo("##choice", getName(context, *index)))
    {
        hasChanged = Choose(index, count, getName, context);
        ImGui::EndCombo();
    }
    EndWidget(label);
    return hasChanged;
}

void UiGraph(const float* values, int count, int offset, float high)
{
    ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 3.0f);
    ImGui::PlotLines("##graph", values, count, offset, nullptr, 0.0f, high, size);
}

void UiBar(float fraction, const char* text)
{
    ImGui::ProgressBar(fraction, ImVec2(-1.0f, 0.0f), text);
}

bool BeginUiTable(const char* label, int columnCount, const UiColumn* columns)
{
    if (!ImGui::BeginTable(label, columnCount, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame))
    {
        return false;
    }
    for (int i = 0; i < columnCount; i++)
    {
        float letter = ImGui::CalcTextSize("0").x;
        bool isFixed = columns[i].letters > 0.0f;
        ImGui::TableSetupColumn(columns[i].title,
                                isFixed ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
                                isFixed ? columns[i].letters * letter : 1.0f);
    }
    ImGui::TableHeadersRow();
    return true;
}

void UiCell(const char* format, ...)
{
    ImGui::TableNextColumn();
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextV(format, arguments);
    va_end(arguments);
}

void UiLabelCell(const char* format, ...)
{
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextV(format, arguments);
    va_end(arguments);
}

void UiNextCell(void)
{
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
}

void EndUiTable(void)
{
    ImGui::EndTable();
}

// One table at a time; gone with its last row, since it must not outlive Dear ImGui's context.
static ImGuiListClipper* rows;

void BeginUiRows(int count)
{
    delete rows;
    rows = new ImGuiListClipper;
    rows->Begin(count);
}

bool StepUiRows(int* first, int* end)
{
    bool isThere = rows->Step();
    *first = rows->DisplayStart;
    *end = rows->DisplayEnd;
    if (!isThere)
    {
        delete rows;
        rows = nullptr;
    }
    return isThere;
}
