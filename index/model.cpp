#include "index/model.h"

namespace ossuary::index {

descriptor::DescribeOptions describe_options(const IndexParameters& parameters) {
    descriptor::DescribeOptions options;
    options.skeletonize.voxelize.resolution = parameters.resolution;
    options.skeletonize.thinning.method = parameters.thinning;
    options.jobs = 0;
    return options;
}

}  // namespace ossuary::index
