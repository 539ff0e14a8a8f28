#include "texset/image_threads.h"

#include <OpenImageIO/imageio.h>

namespace scree {

void set_image_threads(int threads)
{
    OIIO::attribute("threads", threads);
    OIIO::attribute("exr_threads", threads);
}

} // namespace scree
