#include "preview/user_interface.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_vulkan.h>

#include <algorithm>
#include <filesystem>

#include "error.h"
#include "gpu/submission.h"

namespace vernier {
namespace {

/// Fonts that are drawn at any size, the first that is there; else ImGui's own.
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                  "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};
constexpr float kTextPx = 15.0f;

void choose_font(float scale) {
  ImFontAtlas* fonts = ImGui::GetIO().Fonts;
  std::error_code failure;
  for (const char* path : kFonts) {
    if (std::filesystem::exists(path, failure) && fonts->AddFontFromFileTTF(path, kTextPx * scale) != nullptr) return;
  }
  ImFontConfig config;
  config.SizePixels = 13.0f * scale;
  fonts->AddFontDefault(&config);
}

void choose_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.FrameRounding = 4.0f;
  style.GrabRounding = 4.0f;
  style.WindowBorderSize = 0.0f;
  style.WindowPadding = {14.0f, 12.0f};
  style.FramePadding = {8.0f, 4.0f};
  style.ItemSpacing = {8.0f, 7.0f};
  style.Colors[ImGuiCol_WindowBg] = {0.13f, 0.135f, 0.145f, 1.0f};
  style.Colors[ImGuiCol_Header] = {0.20f, 0.22f, 0.26f, 1.0f};
  // Values are written over the grab.
  style.Colors[ImGuiCol_SliderGrab] = {0.30f, 0.44f, 0.66f, 1.0f};
  style.Colors[ImGuiCol_PlotHistogram] = {0.33f, 0.60f, 0.86f, 1.0f};
  style.ScaleAllSizes(scale);
}

void check_result(VkResult result) {
  if (result == VK_ERROR_DEVICE_LOST) throw Error(ErrorKind::device_lost, "drawing the panels: the device was lost");
  if (result < 0) throw Error(ErrorKind::failed, "drawing the panels: Vulkan error " + std::to_string(result));
}

}  // namespace

UserInterface::UserInterface(const Window& window, const VulkanInstance& instance, const Device& device,
                             Presenter& presenter) {
  const vk::DescriptorPoolSize textures(vk::DescriptorType::eCombinedImageSampler, 4);
  pool_ = vk::raii::DescriptorPool(
      device.vk(), vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 4, textures));
  float scale_x = 1.0f, scale_y = 1.0f;
  glfwGetWindowContentScale(window.handle(), &scale_x, &scale_y);
  scale_ = std::clamp(scale_x, 1.0f, 4.0f);
  ImGui::CreateContext();
  // Where the panels lie is ours to say: no file of settings beside the user's.
  ImGui::GetIO().IniFilename = nullptr;
  choose_font(scale_);
  choose_style(scale_);
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo init{};
  init.Instance = *instance.vk();
  init.PhysicalDevice = *device.physical();
  init.Device = *device.vk();
  init.QueueFamily = device.queue_family();
  init.Queue = *device.queue();
  init.DescriptorPool = *pool_;
  init.MinImageCount = 2;
  init.ImageCount = std::max(presenter.image_count(), 2u);
  init.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  init.CheckVkResultFn = check_result;
  ImGui_ImplVulkan_Init(&init, presenter.render_pass());
#if IMGUI_VERSION_NUM < 19000  // later ones upload their font with the first frame
  run_transfer(device, [](const vk::raii::CommandBuffer& commands) { ImGui_ImplVulkan_CreateFontsTexture(*commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

UserInterface::~UserInterface() {
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void UserInterface::begin_frame(const std::function<void()>& put_input) {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  put_input();
  ImGui::NewFrame();
}

void UserInterface::end_frame() {
  ImGui::Render();
}

void UserInterface::record(const vk::raii::CommandBuffer& commands) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
}

}  // namespace vernier
