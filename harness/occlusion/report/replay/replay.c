
/* Everything below is the same in each of these programs: it runs each module once on a Vulkan device. */

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))
#define BUFFERS (3 + IMAGES) /* inputs, outputs, faults, images */
#define END_MARK 0x3f800000u /* the kernel writes it behind the outputs */

static void require(VkResult result, const char *what) {
    if (result == VK_SUCCESS) return;
    fprintf(stderr, "%s: VkResult %d\n", what, (int)result);
    exit(2);
}

static VkDevice device;
static VkPhysicalDevice physical;
static VkQueue queue;
static uint32_t family;

/* The first device whose name contains the text. */
static void open_device(const char *wanted) {
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = VK_API_VERSION_1_2};
    const VkInstanceCreateInfo instance_info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                                .pApplicationInfo = &application};
    VkInstance instance;
    require(vkCreateInstance(&instance_info, NULL, &instance), "vkCreateInstance");
    VkPhysicalDevice all[64];
    uint32_t count = COUNT(all);
    require(vkEnumeratePhysicalDevices(instance, &count, all), "vkEnumeratePhysicalDevices");
    VkPhysicalDeviceProperties properties;
    for (uint32_t i = 0; i < count && physical == VK_NULL_HANDLE; ++i) {
        vkGetPhysicalDeviceProperties(all[i], &properties);
        if (strstr(properties.deviceName, wanted) != NULL) physical = all[i];
    }
    if (physical == VK_NULL_HANDLE) {
        fprintf(stderr, "no Vulkan device whose name contains \"%s\"\n", wanted);
        exit(2);
    }
    printf("device: %s, driver version 0x%x\n", properties.deviceName, (unsigned)properties.driverVersion);
    VkQueueFamilyProperties families[64];
    count = COUNT(families);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families);
    while (family < count && !(families[family].queueFlags & VK_QUEUE_COMPUTE_BIT)) ++family;
    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                                .queueFamilyIndex = family,
                                                .queueCount = 1,
                                                .pQueuePriorities = &priority};
    const VkDeviceCreateInfo device_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                            .queueCreateInfoCount = 1,
                                            .pQueueCreateInfos = &queue_info};
    require(vkCreateDevice(physical, &device_info, NULL, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
}

/* A storage buffer in memory that the host sees, and where it is mapped. */
static VkBuffer make_buffer(const uint32_t *words, size_t count, uint32_t **mapped) {
    const VkBufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                     .size = (count == 0 ? 1 : count) * sizeof(uint32_t),
                                     .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    VkBuffer buffer;
    require(vkCreateBuffer(device, &info, NULL, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffer, &needs);
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    const VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1u) ||
           (memory.memoryTypes[type].propertyFlags & wanted) != wanted)
        ++type;
    const VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                           .allocationSize = needs.size,
                                           .memoryTypeIndex = type};
    VkDeviceMemory bytes;
    require(vkAllocateMemory(device, &allocate, NULL, &bytes), "vkAllocateMemory");
    require(vkBindBufferMemory(device, buffer, bytes, 0), "vkBindBufferMemory");
    require(vkMapMemory(device, bytes, 0, VK_WHOLE_SIZE, 0, (void **)mapped), "vkMapMemory");
    memset(*mapped, 0, (size_t)info.size);
    if (words != NULL) memcpy(*mapped, words, count * sizeof(uint32_t));
    return buffer;
}

static VkPipeline make_pipeline(const struct module *module, VkPipelineLayout layout) {
    const VkShaderModuleCreateInfo shader_info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                  .codeSize = module->bytes,
                                                  .pCode = module->words};
    VkShaderModule shader;
    require(vkCreateShaderModule(device, &shader_info, NULL, &shader), "vkCreateShaderModule");
    VkSpecializationMapEntry entries[COUNT(inputs)];
    for (uint32_t i = 0; i < COUNT(inputs); ++i)
        entries[i] = (VkSpecializationMapEntry){i, i * (uint32_t)sizeof(uint32_t), sizeof(uint32_t)};
    const VkSpecializationInfo constants = {COUNT(inputs), entries, sizeof(inputs), inputs};
    const VkComputePipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = shader,
                  .pName = "main",
                  .pSpecializationInfo = SPECIALIZED ? &constants : NULL},
        .layout = layout};
    VkPipeline pipeline;
    require(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, NULL, &pipeline),
            "vkCreateComputePipelines");
    return pipeline;
}

static VkDescriptorSetLayout make_set_layout(void) {
    VkDescriptorSetLayoutBinding bindings[BUFFERS];
    for (uint32_t i = 0; i < BUFFERS; ++i)
        bindings[i] = (VkDescriptorSetLayoutBinding){
            i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, NULL};
    const VkDescriptorSetLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = BUFFERS,
        .pBindings = bindings};
    VkDescriptorSetLayout layout;
    require(vkCreateDescriptorSetLayout(device, &info, NULL, &layout), "vkCreateDescriptorSetLayout");
    return layout;
}

static VkDescriptorSet make_set(VkDescriptorSetLayout layout, const VkBuffer *buffers) {
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, BUFFERS};
    const VkDescriptorPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                                  .maxSets = 1,
                                                  .poolSizeCount = 1,
                                                  .pPoolSizes = &size};
    VkDescriptorPool pool;
    require(vkCreateDescriptorPool(device, &pool_info, NULL, &pool), "vkCreateDescriptorPool");
    const VkDescriptorSetAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                  .descriptorPool = pool,
                                                  .descriptorSetCount = 1,
                                                  .pSetLayouts = &layout};
    VkDescriptorSet set;
    require(vkAllocateDescriptorSets(device, &allocate, &set), "vkAllocateDescriptorSets");
    for (uint32_t i = 0; i < BUFFERS; ++i) {
        const VkDescriptorBufferInfo buffer = {buffers[i], 0, VK_WHOLE_SIZE};
        const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = set,
                                            .dstBinding = i,
                                            .descriptorCount = 1,
                                            .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                            .pBufferInfo = &buffer};
        vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
    }
    return set;
}

static void dispatch(VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set) {
    const VkCommandPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                               .queueFamilyIndex = family};
    VkCommandPool pool;
    require(vkCreateCommandPool(device, &pool_info, NULL, &pool), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = pool,
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
    VkCommandBuffer commands;
    require(vkAllocateCommandBuffers(device, &allocate, &commands), "vkAllocateCommandBuffers");
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    require(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, NULL);
    const uint32_t run[] = {1, ROW_LENGTH, END_MARK}; /* inputs, invocations in a row, the mark */
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(run), run);
    vkCmdDispatch(commands, 1, 1, 1);
    const VkMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, NULL, 0, NULL);
    require(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    require(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    require(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
}

/* Prints an output beside what is allowed. Returns whether it is outside. */
static int judge(size_t i, uint32_t word) {
    const struct output *expected = &outputs[i];
    float value;
    memcpy(&value, &word, sizeof(value));
    const double number = expected->is_float ? value : expected->low < 0 ? (int32_t)word : (double)word;
    const int allowed =
        isnan(number) ? expected->nan : number >= expected->low && number <= expected->high;
    printf("  output %zu: 0x%08x %.9g, expected %.17g to %.17g%s: %s\n", i, (unsigned)word, number,
           expected->low, expected->high, expected->nan ? " or NaN" : "", allowed ? "ok" : "OUTSIDE");
    return !allowed;
}

static int run_module(const struct module *module) {
    VkBuffer buffers[BUFFERS];
    uint32_t *mapped[BUFFERS];
    buffers[0] = make_buffer(inputs, COUNT(inputs), &mapped[0]);
    buffers[1] = make_buffer(NULL, COUNT(outputs) + 1 + 64, &mapped[1]);
    buffers[2] = make_buffer(NULL, 5, &mapped[2]);
    for (size_t i = 0; i + 3 < BUFFERS; ++i)
        buffers[3 + i] = make_buffer(images[i].words, images[i].count, &mapped[3 + i]);
    const VkDescriptorSetLayout set_layout = make_set_layout();
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, 12};
    const VkPipelineLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                             .setLayoutCount = 1,
                                             .pSetLayouts = &set_layout,
                                             .pushConstantRangeCount = 1,
                                             .pPushConstantRanges = &range};
    VkPipelineLayout layout;
    require(vkCreatePipelineLayout(device, &info, NULL, &layout), "vkCreatePipelineLayout");
    dispatch(make_pipeline(module, layout), layout, make_set(set_layout, buffers));
    printf("%s:\n", module->name);
    int outside = 0;
    for (size_t i = 0; i < COUNT(outputs); ++i) outside += judge(i, mapped[1][i]);
    if (mapped[1][COUNT(outputs)] != END_MARK) {
        printf("  the kernel did not run to its end\n");
        ++outside;
    }
    return outside;
}

/* PROGRAM [PART OF A DEVICE'S NAME]: exit status 1 if an output of the first module is outside, 2 if it could
   not run. */
int main(int argc, char **argv) {
    open_device(argc > 1 ? argv[1] : "");
    int outside = 0;
    for (size_t i = 0; i < COUNT(modules); ++i) {
        const int here = run_module(&modules[i]);
        if (i == 0) outside = here;
    }
    return outside > 0;
}
