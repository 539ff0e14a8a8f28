#include "pipeline/mesh_options.h"

#include "pipeline/named_choice.h"

namespace scree {

namespace {

const Choices<Scheme> kSchemes = {{"catmull-clark", Scheme::catmull_clark}, {"loop", Scheme::loop}};
const Choices<BoundaryRule> kBoundaries = {{"edge-and-corner", BoundaryRule::edge_and_corner},
                                           {"edge-only", BoundaryRule::edge_only},
                                           {"none", BoundaryRule::none}};
const Choices<UvRule> kUvRules = {{"all", UvRule::all},
                                  {"boundaries", UvRule::boundaries},
                                  {"corners-plus2", UvRule::corners_plus2},
                                  {"corners-plus1", UvRule::corners_plus1},
                                  {"corners-only", UvRule::corners_only},
                                  {"none", UvRule::none}};

} // namespace

Scheme scheme_named(const std::string& name) { return named("--scheme", name, kSchemes); }
std::string scheme_name(Scheme scheme) { return name_of(scheme, kSchemes); }

BoundaryRule boundary_named(const std::string& name)
{
    return named("--boundary", name, kBoundaries);
}
std::string boundary_name(BoundaryRule rule) { return name_of(rule, kBoundaries); }

UvRule uv_interpolation_named(const std::string& name)
{
    return named("--uv-interpolation", name, kUvRules);
}
std::string uv_interpolation_name(UvRule rule) { return name_of(rule, kUvRules); }

} // namespace scree
