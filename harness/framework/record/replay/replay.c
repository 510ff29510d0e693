
/* Everything below is the same in each of these programs: it runs each module once on a Vulkan device. */

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))
#define BINDINGS (3 + IMAGES) /* buffers of inputs, outputs, faults; images */
#define WIDTH (COUNT(is_float) + 1) /* words in the output buffer for an input */
#define END_MARK 0x3f800000u /* the kernel writes it, xor the input's number, behind its outputs */

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
        fprintf(stderr, "no Vulkan device whose name contains \"%s\", expected one of these names as argument:\n",
                wanted);
        for (uint32_t i = 0; i < count; ++i) {
            vkGetPhysicalDeviceProperties(all[i], &properties);
            fprintf(stderr, "    %s\n", properties.deviceName);
        }
        fprintf(stderr, "or in VK_DRIVER_FILES the manifest of a driver that the Vulkan loader does not look for\n");
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
    VkPhysicalDeviceFeatures features;
    vkGetPhysicalDeviceFeatures(physical, &features);
    const VkPhysicalDeviceFeatures enabled = {.imageCubeArray = features.imageCubeArray,
                                              .shaderImageGatherExtended = features.shaderImageGatherExtended};
    const VkDeviceCreateInfo device_info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                            .queueCreateInfoCount = 1,
                                            .pQueueCreateInfos = &queue_info,
                                            .pEnabledFeatures = &enabled};
    require(vkCreateDevice(physical, &device_info, NULL, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
}

static VkDeviceMemory allocate(VkMemoryRequirements needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    uint32_t type = 0;
    while (!(needs.memoryTypeBits >> type & 1u) ||
           (memory.memoryTypes[type].propertyFlags & wanted) != wanted)
        ++type;
    const VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                       .allocationSize = needs.size,
                                       .memoryTypeIndex = type};
    VkDeviceMemory result;
    require(vkAllocateMemory(device, &info, NULL, &result), "vkAllocateMemory");
    return result;
}

/* A buffer in memory that the host sees, and where it is mapped. */
static VkBuffer make_buffer(const uint32_t *words, size_t count, uint32_t **mapped) {
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
        .size = (count == 0 ? 1 : count) * sizeof(uint32_t),
        .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT};
    VkBuffer buffer;
    require(vkCreateBuffer(device, &info, NULL, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device, buffer, &needs);
    const VkDeviceMemory bytes =
        allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    require(vkBindBufferMemory(device, buffer, bytes, 0), "vkBindBufferMemory");
    require(vkMapMemory(device, bytes, 0, VK_WHOLE_SIZE, 0, (void **)mapped), "vkMapMemory");
    memset(*mapped, 0, (size_t)info.size);
    if (words != NULL) memcpy(*mapped, words, count * sizeof(uint32_t));
    return buffer;
}

static VkCommandBuffer begin_commands(void) {
    const VkCommandPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                               .queueFamilyIndex = family};
    VkCommandPool pool;
    require(vkCreateCommandPool(device, &pool_info, NULL, &pool), "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo allocate_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                       .commandPool = pool,
                                                       .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                       .commandBufferCount = 1};
    VkCommandBuffer commands;
    require(vkAllocateCommandBuffers(device, &allocate_info, &commands), "vkAllocateCommandBuffers");
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    require(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    return commands;
}

/* Runs them and waits. */
static void run_commands(VkCommandBuffer commands) {
    require(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    const VkSubmitInfo submit = {
        .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    require(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
    require(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
}

/* Of an image for a sampler, before its texels, which stand level by level. */
struct sampled {
    uint32_t width, height, depth, levels; /* depth: or layers */
    uint32_t shape;                        /* index of view_types[] */
    uint32_t texel;                        /* index of formats[] */
    uint32_t linear;                       /* also between levels */
    uint32_t wrap, comparison;             /* indices of wraps[], comparisons[] */
};
static const VkImageViewType view_types[] = {VK_IMAGE_VIEW_TYPE_2D,   VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                                             VK_IMAGE_VIEW_TYPE_3D,   VK_IMAGE_VIEW_TYPE_CUBE,
                                             VK_IMAGE_VIEW_TYPE_CUBE_ARRAY, VK_IMAGE_VIEW_TYPE_1D};
static const VkFormat formats[] = {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32G32B32A32_SINT,
                                   VK_FORMAT_R32G32B32A32_UINT, VK_FORMAT_D32_SFLOAT};
static const uint32_t texel_bytes[] = {8, 16, 16, 4};
static const VkSamplerAddressMode wraps[] = {
    VK_SAMPLER_ADDRESS_MODE_REPEAT, VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT,
    VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER};
static const VkCompareOp comparisons[] = {VK_COMPARE_OP_LESS_OR_EQUAL, VK_COMPARE_OP_GREATER_OR_EQUAL,
                                          VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER};

static VkSampler make_sampler(const struct sampled *from, int depths) {
    const VkFilter filter = from->linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    const VkSamplerCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
        .magFilter = filter,
        .minFilter = filter,
        .mipmapMode = from->linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST,
        .addressModeU = wraps[from->wrap],
        .addressModeV = wraps[from->wrap],
        .addressModeW = wraps[from->wrap],
        .compareEnable = depths,
        .compareOp = comparisons[from->comparison],
        .maxLod = VK_LOD_CLAMP_NONE,
        .borderColor = from->texel == 0 || depths ? VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK
                                                  : VK_BORDER_COLOR_INT_TRANSPARENT_BLACK};
    VkSampler sampler;
    require(vkCreateSampler(device, &info, NULL, &sampler), "vkCreateSampler");
    return sampler;
}

static void fill_image(VkImage image, const struct sampled *from, VkImageSubresourceRange all, VkBuffer texels) {
    const int solid = view_types[from->shape] == VK_IMAGE_VIEW_TYPE_3D;
    const VkCommandBuffer commands = begin_commands();
    VkImageMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                    .dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
                                    .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
                                    .newLayout = VK_IMAGE_LAYOUT_GENERAL,
                                    .image = image,
                                    .subresourceRange = all};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, NULL,
                         0, NULL, 1, &barrier);
    VkDeviceSize offset = 0;
    for (uint32_t level = 0; level < from->levels; ++level) {
        const uint32_t width = from->width >> level ? from->width >> level : 1;
        const uint32_t height = from->height >> level ? from->height >> level : 1;
        const uint32_t depth = !solid ? 1 : from->depth >> level ? from->depth >> level : 1;
        const VkBufferImageCopy copy = {.bufferOffset = offset,
                                        .imageSubresource = {all.aspectMask, level, 0, all.layerCount},
                                        .imageExtent = {width, height, depth}};
        vkCmdCopyBufferToImage(commands, texels, image, VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
        offset += (VkDeviceSize)width * height * depth * all.layerCount * texel_bytes[from->texel];
    }
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0,
                         NULL, 0, NULL, 1, &barrier);
    run_commands(commands);
}

/* The image that the words describe: struct sampled, then the texels. */
static VkDescriptorImageInfo make_image(const uint32_t *words, size_t count) {
    struct sampled from;
    memcpy(&from, words, sizeof(from));
    const VkImageViewType type = view_types[from.shape];
    const int solid = type == VK_IMAGE_VIEW_TYPE_3D;
    const int cube = type == VK_IMAGE_VIEW_TYPE_CUBE || type == VK_IMAGE_VIEW_TYPE_CUBE_ARRAY;
    const int depths = formats[from.texel] == VK_FORMAT_D32_SFLOAT;
    const VkImageSubresourceRange all = {
        .aspectMask = depths ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT,
        .levelCount = from.levels,
        .layerCount = solid ? 1 : from.depth};
    const VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                    .flags = cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0,
                                    .imageType = solid                            ? VK_IMAGE_TYPE_3D
                                                 : type == VK_IMAGE_VIEW_TYPE_1D ? VK_IMAGE_TYPE_1D
                                                                                  : VK_IMAGE_TYPE_2D,
                                    .format = formats[from.texel],
                                    .extent = {from.width, from.height, solid ? from.depth : 1},
                                    .mipLevels = from.levels,
                                    .arrayLayers = all.layerCount,
                                    .samples = VK_SAMPLE_COUNT_1_BIT,
                                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
    VkImage image;
    require(vkCreateImage(device, &info, NULL, &image), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device, image, &needs);
    require(vkBindImageMemory(device, image, allocate(needs, 0), 0), "vkBindImageMemory");
    uint32_t *mapped;
    const size_t header = sizeof(from) / sizeof(uint32_t);
    fill_image(image, &from, all, make_buffer(words + header, count - header, &mapped));
    const VkImageViewCreateInfo view_info = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                             .image = image,
                                             .viewType = type,
                                             .format = formats[from.texel],
                                             .subresourceRange = all};
    VkDescriptorImageInfo result = {.sampler = make_sampler(&from, depths), .imageLayout = VK_IMAGE_LAYOUT_GENERAL};
    require(vkCreateImageView(device, &view_info, NULL, &result.imageView), "vkCreateImageView");
    return result;
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

static VkDescriptorType type_of(uint32_t binding) {
    return binding >= 3 && images[binding - 3].sampled ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                       : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

static VkDescriptorSetLayout make_set_layout(void) {
    VkDescriptorSetLayoutBinding bindings[BINDINGS];
    for (uint32_t i = 0; i < BINDINGS; ++i)
        bindings[i] =
            (VkDescriptorSetLayoutBinding){i, type_of(i), 1, VK_SHADER_STAGE_COMPUTE_BIT, NULL};
    const VkDescriptorSetLayoutCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = BINDINGS,
        .pBindings = bindings};
    VkDescriptorSetLayout layout;
    require(vkCreateDescriptorSetLayout(device, &info, NULL, &layout), "vkCreateDescriptorSetLayout");
    return layout;
}

struct resource {
    VkDescriptorBufferInfo buffer;
    VkDescriptorImageInfo image;
    uint32_t *mapped; /* of a buffer */
};

static struct resource make_resource(const uint32_t *words, size_t count) {
    struct resource result = {.buffer = {.range = VK_WHOLE_SIZE}};
    result.buffer.buffer = make_buffer(words, count, &result.mapped);
    return result;
}

static VkDescriptorSet make_set(VkDescriptorSetLayout layout, const struct resource *resources) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, BINDINGS},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, BINDINGS}};
    const VkDescriptorPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                                  .maxSets = 1,
                                                  .poolSizeCount = COUNT(sizes),
                                                  .pPoolSizes = sizes};
    VkDescriptorPool pool;
    require(vkCreateDescriptorPool(device, &pool_info, NULL, &pool), "vkCreateDescriptorPool");
    const VkDescriptorSetAllocateInfo set_info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                  .descriptorPool = pool,
                                                  .descriptorSetCount = 1,
                                                  .pSetLayouts = &layout};
    VkDescriptorSet set;
    require(vkAllocateDescriptorSets(device, &set_info, &set), "vkAllocateDescriptorSets");
    for (uint32_t i = 0; i < BINDINGS; ++i) {
        const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = set,
                                            .dstBinding = i,
                                            .descriptorCount = 1,
                                            .descriptorType = type_of(i),
                                            .pBufferInfo = &resources[i].buffer,
                                            .pImageInfo = &resources[i].image};
        vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
    }
    return set;
}

static void dispatch(VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set) {
    const VkCommandBuffer commands = begin_commands();
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, NULL);
    const uint32_t run[] = {RUNS, ROW_LENGTH, END_MARK}; /* inputs, invocations in a row, the mark */
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(run), run);
    vkCmdDispatch(commands, 1, 1, 1);
    const VkMemoryBarrier barrier = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                     .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                     .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, NULL, 0, NULL);
    run_commands(commands);
}

/* Prints an output beside its ranges. Returns whether it is outside all of them. Clears the outcomes without it. */
static int judge(size_t i, uint32_t word, unsigned char *outcome_holds) {
    float value;
    memcpy(&value, &word, sizeof(value));
    int allowed = 0;
    printf("  output %zu: 0x%08x", i, (unsigned)word);
    for (size_t k = 0; k < COUNT(outcomes); ++k) {
        const struct range *range = &outcomes[k][i];
        const double number = is_float[i] ? value : range->low < 0 ? (int32_t)word : (double)word;
        const int inside = isnan(number) ? range->nan : number >= range->low && number <= range->high;
        allowed |= inside;
        outcome_holds[k] &= (unsigned char)inside;
        if (k == 0) printf(" %.9g, expected", number);
        if (range->repeated) continue;
        if (k > 0) printf(", or");
        if (range->low <= range->high) printf(" %.17g", range->low);
        if (range->low < range->high) printf(" to %.17g", range->high);
        if (range->nan) printf(range->low <= range->high ? " or NaN" : " NaN");
    }
    printf(": %s\n", allowed ? "ok" : "OUTSIDE");
    return !allowed;
}

static int run_module(const struct module *module) {
    struct resource resources[BINDINGS] = {make_resource(inputs, COUNT(inputs)),
                                           make_resource(NULL, RUNS * WIDTH + 64),
                                           make_resource(NULL, 5)};
    for (size_t i = 0; i + 3 < BINDINGS; ++i)
        if (images[i].sampled)
            resources[3 + i].image = make_image(images[i].words, images[i].count);
        else
            resources[3 + i] = make_resource(images[i].words, images[i].count);
    const VkDescriptorSetLayout set_layout = make_set_layout();
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, 12};
    const VkPipelineLayoutCreateInfo info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                             .setLayoutCount = 1,
                                             .pSetLayouts = &set_layout,
                                             .pushConstantRangeCount = 1,
                                             .pPushConstantRanges = &range};
    VkPipelineLayout layout;
    require(vkCreatePipelineLayout(device, &info, NULL, &layout), "vkCreatePipelineLayout");
    dispatch(make_pipeline(module, layout), layout, make_set(set_layout, resources));
    printf("%s:\n", module->name);
    const uint32_t *const outputs = resources[1].mapped + JUDGED * WIDTH;
    int outside = 0;
    unsigned char outcome_holds[COUNT(outcomes)];
    memset(outcome_holds, 1, sizeof(outcome_holds));
    for (size_t i = 0; i < COUNT(is_float); ++i) outside += judge(i, outputs[i], outcome_holds);
    if (outside == 0 && memchr(outcome_holds, 1, sizeof(outcome_holds)) == NULL) {
        printf("  no outcome has all outputs together: OUTSIDE\n");
        ++outside;
    }
    if (outputs[COUNT(is_float)] != (END_MARK ^ JUDGED)) {
        printf("  the kernel did not run to its end\n");
        ++outside;
    }
    return outside;
}

/* PROGRAM [PART OF A DEVICE'S NAME]: exit status 1 if no outcome contains the outputs of the first module, 2 if
   it could not run. */
int main(int argc, char **argv) {
    open_device(argc > 1 ? argv[1] : FOUND_ON);
    int outside = 0;
    for (size_t i = 0; i < COUNT(modules); ++i) {
        const int here = run_module(&modules[i]);
        if (i == 0) outside = here;
    }
    return outside > 0;
}
