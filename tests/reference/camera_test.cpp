// Rays go where the picture says.

#include "reference/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/reliefs.h"

namespace scree::test {
namespace {

using reference::Aim;
using reference::Camera;
using reference::Ray;

constexpr double kRounding = 1e-9; // of numbers up to a few hundred

Aim aim_at(double angle_deg, double azimuth_deg)
{
    Aim aim;
    aim.target = {3, -2};
    aim.plane = 0.5;
    aim.angle_rad = radians(angle_deg);
    aim.azimuth_rad = radians(azimuth_deg);
    aim.width = 10;
    aim.columns = 40;
    aim.rows = 20;
    return aim;
}

/// Both kinds, from several sides.
std::vector<Camera> cameras()
{
    std::vector<Camera> all;
    for (const double angle : {0.0, 40.0, 75.0})
        for (const double azimuth : {90.0, 200.0, -30.0}) {
            all.push_back(Camera::pinhole(aim_at(angle, azimuth), radians(25)));
            all.push_back(Camera::distant(aim_at(angle, azimuth), 7));
        }
    return all;
}

/// Where a ray meets a level plane.
Vec3 met(const Ray& ray, double height)
{
    return ray.origin + (height - ray.origin.z) / ray.direction.z * ray.direction;
}

TEST(Camera, TheMiddleOfThePictureIsTheTargetSeenFromItsAngle)
{
    for (const double angle : {0.0, 40.0, 75.0})
        for (const double azimuth : {90.0, 200.0}) {
            const Aim aim = aim_at(angle, azimuth);
            for (const Camera& camera :
                 {Camera::pinhole(aim, radians(25)), Camera::distant(aim, 7)}) {
                const Ray ray = camera.ray(20, 10);
                const Vec3 to_viewer = direction(angle, azimuth);
                EXPECT_LT((ray.direction + to_viewer).length(), kRounding);
                EXPECT_LT((met(ray, 0.5) - Vec3(3, -2, 0.5)).length(), kRounding);
            }
        }
}

TEST(Camera, TheMiddleRowShowsItsWidth)
{
    for (const Camera& camera : cameras()) {
        const Vec3 left = met(camera.ray(0, 10), 0.5), right = met(camera.ray(40, 10), 0.5);
        EXPECT_NEAR((right - left).length(), 10, kRounding);
    }
}

TEST(Camera, FromTheBottomOfTheMapItLiesAsItsImageDoes)
{
    for (const Camera& camera :
         {Camera::pinhole(aim_at(30, 90), radians(25)), Camera::distant(aim_at(30, 90), 7)}) {
        const Vec3 middle = met(camera.ray(20, 10), 0.5);
        const Vec3 right = met(camera.ray(21, 10), 0.5) - middle;
        const Vec3 down = met(camera.ray(20, 11), 0.5) - middle;
        EXPECT_GT(right.x, 0);
        EXPECT_NEAR(right.y, 0, kRounding);
        EXPECT_NEAR(down.x, 0, kRounding);
        EXPECT_GT(down.y, right.x); // foreshortened: a pixel reaches further along the view
    }
}

TEST(Camera, ThePinholesRaysComeFromOnePlaceAndOpenByItsField)
{
    const Camera camera = Camera::pinhole(aim_at(50, 20), radians(25));
    EXPECT_LT((camera.ray(3, 4).origin - camera.ray(33, 17).origin).length(), kRounding);
    const double cosine = camera.ray(20, 0).direction.dot(camera.ray(20, 20).direction);
    EXPECT_NEAR(std::acos(cosine), radians(25), kRounding);
}

TEST(Camera, DistantRaysAreParallelAndStartClearOfAll)
{
    const Camera camera = Camera::distant(aim_at(50, 20), 7);
    for (const double x : {0.0, 13.0, 40.0})
        for (const double y : {0.0, 20.0}) {
            EXPECT_LT((camera.ray(x, y).direction + direction(50, 20)).length(), kRounding);
            EXPECT_NEAR(camera.ray(x, y).origin.z, 7, kRounding);
        }
    // Square pixels: 0.25 across, and as much across the view.
    const Vec3 step = camera.ray(0, 1).origin - camera.ray(0, 0).origin;
    const Vec3 view = direction(50, 20);
    EXPECT_NEAR((step - view * view.dot(step)).length(), 0.25, kRounding);
}

TEST(Camera, ThePlaneIsWhereTheRayMeetsIt)
{
    for (const Camera& camera : cameras())
        for (const double height : {-1.0, 0.5, 2.0}) {
            const auto view = camera.view_of_plane(height, 11, 13);
            ASSERT_TRUE(view);
            const Ray ray = camera.ray(11, 13);
            const Vec3 place = met(ray, height);
            EXPECT_NEAR(view->place.x, place.x, kRounding);
            EXPECT_NEAR(view->place.y, place.y, kRounding);
            EXPECT_LT((view->to_viewer + ray.direction).length(), kRounding);
        }
}

TEST(Camera, TheFootprintIsTheDerivativeOfThePlace)
{
    constexpr double kStep = 1e-4; // central differences: error of its square, and rounding / kStep
    for (const Camera& camera : cameras()) {
        const auto view = camera.view_of_plane(0.5, 11, 13);
        ASSERT_TRUE(view);
        auto difference = [&](double dx, double dy) {
            const Vec2 after = camera.view_of_plane(0.5, 11 + dx, 13 + dy)->place;
            const Vec2 before = camera.view_of_plane(0.5, 11 - dx, 13 - dy)->place;
            return (after - before) / (2 * kStep);
        };
        EXPECT_LT((view->along_x - difference(kStep, 0)).length(), 1e-7);
        EXPECT_LT((view->along_y - difference(0, kStep)).length(), 1e-7);
    }
}

TEST(Camera, AboveTheHorizonThereIsNoPlane)
{
    Aim aim = aim_at(80, 90);
    const Camera camera = Camera::pinhole(aim, radians(30));
    // The horizon is 10 degrees above the middle.
    const double horizon = 10 - 10 * std::tan(radians(10)) / std::tan(radians(15));
    EXPECT_FALSE(camera.view_of_plane(0, 20, horizon - 0.01));
    EXPECT_TRUE(camera.view_of_plane(0, 20, horizon + 0.01));
    EXPECT_FALSE(camera.view_of_plane(1000, 20, 15)) << "a plane above the camera";
}

} // namespace
} // namespace scree::test
