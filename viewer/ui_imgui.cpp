// SPDX-License-Identifier: MIT
// The panel's widgets by Dear ImGui, whose context and window backend live here. What it wants drawn is handed on as
// plain arrays; ui_draw.c says why its own Vulkan backend is left out.

extern "C"
{
#include "ui.h"
}

#include <cstdarg>
#include <cstddef>
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

static void SetStyle(float scale)
{
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 4.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.WindowBorderSize = 0.0f;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.05f, 0.08f, 0.10f, 0.84f);
    style.Colors[ImGuiCol_TitleBgActive] = ImVec4(0.07f, 0.24f, 0.31f, 0.95f);
    style.Colors[ImGuiCol_Header] = ImVec4(0.10f, 0.30f, 0.38f, 0.75f);
    style.Colors[ImGuiCol_HeaderHovered] = ImVec4(0.14f, 0.40f, 0.50f, 0.85f);
    style.Colors[ImGuiCol_HeaderActive] = ImVec4(0.16f, 0.46f, 0.57f, 1.0f);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.17f, 0.25f, 0.29f, 0.90f);
    style.Colors[ImGuiCol_FrameBgHovered] = ImVec4(0.17f, 0.30f, 0.36f, 0.80f);
    style.Colors[ImGuiCol_FrameBgActive] = ImVec4(0.19f, 0.37f, 0.44f, 0.90f);
    style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.31f, 0.67f, 0.78f, 1.0f);
    style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0.45f, 0.83f, 0.93f, 1.0f);
    style.Colors[ImGuiCol_CheckMark] = ImVec4(0.45f, 0.83f, 0.93f, 1.0f);
    style.Colors[ImGuiCol_Button] = ImVec4(0.12f, 0.33f, 0.41f, 0.80f);
    style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.16f, 0.46f, 0.57f, 1.0f);
    style.Colors[ImGuiCol_TableHeaderBg] = ImVec4(0.08f, 0.17f, 0.21f, 1.0f);
    style.Colors[ImGuiCol_PlotHistogram] = ImVec4(0.31f, 0.67f, 0.78f, 1.0f);
    style.Colors[ImGuiCol_PlotLines] = ImVec4(0.45f, 0.83f, 0.93f, 1.0f);
    style.ScaleAllSizes(scale);
    ImGui::GetIO().FontGlobalScale = scale;
}

bool OpenUi(GLFWwindow* window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.BackendRendererName = "seaway";
    float scaleX = 1.0f, scaleY = 1.0f;
    glfwGetWindowContentScale(window, &scaleX, &scaleY);
    SetStyle(scaleX);
    return ImGui_ImplGlfw_InitForVulkan(window, true);
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

void BeginUiFrame(void)
{
    ImGui_ImplGlfw_NewFrame();
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
    float scale = ImGui::GetIO().FontGlobalScale;
    ImVec2 room(viewport->WorkSize.x - 20.0f, viewport->WorkSize.y - 20.0f);
    ImGui::SetNextWindowPos(ImVec2(10.0f, 10.0f), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(room.x < 390.0f * scale ? room.x : 390.0f * scale, room.y), ImGuiCond_FirstUseEver);
    ImGui::Begin(title, nullptr, ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushItemWidth(ImGui::GetFontSize() * 13.0f);
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

void UiFaint(const char* format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    ImGui::TextColoredV(faintColor, format, arguments);
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
    if (ImGui::IsItemHovered())
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
    return ImGui::Button(label);
}

bool UiCheckbox(const char* label, bool* value)
{
    return ImGui::Checkbox(label, value);
}

bool UiSlider(const char* label, float* value, float low, float high, const char* format)
{
    return ImGui::SliderFloat(label, value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
}

bool UiLogSlider(const char* label, float* value, float low, float high, const char* format)
{
    return ImGui::SliderFloat(label, value, low, high, format,
                              ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
}

bool UiSliderInt(const char* label, int* value, int low, int high, const char* format)
{
    return ImGui::SliderInt(label, value, low, high, format, ImGuiSliderFlags_AlwaysClamp);
}

bool UiDoubleSlider(const char* label, double* value, double low, double high, const char* format)
{
    return ImGui::SliderScalar(label, ImGuiDataType_Double, value, &low, &high, format, ImGuiSliderFlags_AlwaysClamp);
}

bool UiColor(const char* label, swVec3* rgb)
{
    return ImGui::ColorEdit3(label, &rgb->x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
}

bool UiChoice(const char* label, int* index, int count, UiItemFcn getName, void* context)
{
    bool hasChanged = false;
    if (ImGui::BeginCombo(label, getName(context, *index)))
    {
        for (int i = 0; i < count; i++)
        {
            ImGui::PushID(i);
            if (ImGui::Selectable(getName(context, i), i == *index))
            {
                hasChanged = i != *index;
                *index = i;
            }
            if (i == *index)
            {
                ImGui::SetItemDefaultFocus();
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    return hasChanged;
}

void UiGraph(const char* label, const float* values, int count, int offset, float high)
{
    ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 4.0f);
    ImGui::PlotLines("", values, count, offset, label, 0.0f, high, size);
}

void UiBar(float fraction, const char* text)
{
    ImGui::ProgressBar(fraction, ImVec2(-1.0f, 0.0f), text);
}

bool BeginUiTable(const char* label, int columnCount, const char* const* titles)
{
    if (!ImGui::BeginTable(label, columnCount, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    {
        return false;
    }
    for (int i = 0; i < columnCount; i++)
    {
        ImGui::TableSetupColumn(titles[i]);
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

void UiNextCell(void)
{
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
}

void EndUiTable(void)
{
    ImGui::EndTable();
}
