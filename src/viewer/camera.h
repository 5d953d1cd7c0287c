#pragma once

#include "render/raster.h"
#include "viewer/globe.h"

#include <memory>
#include <optional>

namespace dsphere::viewer {

/// Where a camera is: an eye and three axes, of the handedness and lengths that the scene's own transform has.
struct Pose {
    dvec3 eye, right, up, ahead;

    static Pose of(const Camera& camera);
    dmat4 cameraFromWorld() const;
    /// +1 if right = up x ahead (pbrt's own), -1 in a scene that is mirrored.
    double handedness() const;
    void turn(const dmat3& rotation, const dvec3& about);
};

/// A ray through a point of the window; direction is unit.
struct CursorRay {
    dvec3 origin, direction;
};

/// What is under the cursor: a world point of one of the scene's shapes.
struct Hit {
    dvec3 point;
    std::size_t shape;
};

/// About a unit axis, right-handed.
dmat3 rotationAbout(const dvec3& axis, double angle);

/// From where axisView() looks: latitude 0 and longitude 0, 180, 90, -90; the poles; the corner between 0, 90 and the
/// north pole.
enum class Side { Front, Back, Right, Left, North, South, Corner };

/// The camera as the mouse and keys move it. Cursor positions are pixels of the film, y downward. Drags go from where
/// the cursor grabbed, never from the last event, so nothing drifts. All turning is about the target, one of the
/// scene's shapes: what was grabbed last.
class CameraControl {
  public:
    /// The nearest that the eye comes to the ground, in R.
    static constexpr double kLowest = 1e-3;
    /// The fewest pixels across which all of the scene is seen, however far the eye goes.
    static constexpr double kFewestPixels = 8.0;

    CameraControl(const Camera& camera, const Film& film, std::shared_ptr<const Bodies> bodies, std::size_t target);

    const Camera& camera() const { return camera_; }
    std::size_t target() const { return target_; }
    const Globe& globe() const { return (*bodies_)[target_]; }
    /// The distance to the nearest ground or shape; negative inside a planet.
    double altitude() const { return bodies_->clearance(pose_.eye); }
    CursorRay rayAt(const dvec2& cursor) const;

    void resize(int width, int height);
    /// Other ground. Where it swallows the eye, this moves out as the globe has grown, and comes back with it if
    /// nothing else has moved it meanwhile. True: by more than a tenth of the radius.
    bool setBodies(std::shared_ptr<const Bodies> bodies);
    void setTarget(std::size_t shape) { target_ = shape; }
    void setCamera(const Camera& camera);
    /// Back to where it started; where the ground has risen past that, to all of the globe from that side.
    void reset();
    /// The whole globe from a side, north up.
    void axisView(Side side);
    /// The whole globe from where the eye is, north up.
    void frame();
    /// North up; near the ground level, looking north.
    void northUp();
    /// Over the ground, as the window shows it: right, up. A step is a tenth of a radian or of the eye's height.
    void moveOver(const dvec2& steps);
    /// Straight down on a place of the target, north up; a round one. Degrees; above the ground, in world units.
    Pose poseAbove(double latitude, double longitude, double altitude) const;
    const Pose& pose() const { return pose_; }
    void setPose(const Pose& pose);

    /// Starts a drag; `hit` is what is under the cursor, if anything, and becomes the target.
    void grab(const dvec2& cursor, const std::optional<Hit>& hit);
    /// Turns the globe: the grabbed ground stays under the cursor, north stays as far up as it was. Beside the globe
    /// half a turn a window; where the sky was grabbed near the ground, looks around.
    void orbitTo(const dvec2& cursor);
    /// Moves sideways: what was grabbed stays under the cursor.
    void panTo(const dvec2& cursor);
    /// Turns about what was grabbed: its vertical, and up to the horizon. Looks around where that was the sky near the
    /// ground.
    void tiltTo(const dvec2& cursor);

    /// Towards (steps > 0) or away from what is under the cursor, which stays there.
    void zoom(const dvec2& cursor, const std::optional<dvec3>& hit, double steps);
    /// Along the camera's axes (right, up, ahead), each -1 to 1, for some seconds; as fast as the eye is high.
    void fly(const dvec3& along, double seconds);

  private:
    Pose facing(const dvec3& eye, const dvec3& ahead, const dvec3& upward) const;
    void showWhole(const dvec3& outward, const dvec3& upward);
    dvec3 northAt(const dvec3& outward) const;
    dvec3 pivot(const dvec2& cursor, const std::optional<dvec3>& hit) const;
    std::optional<dvec3> onSphere(const CursorRay& ray, double radius) const;
    dmat3 levelling(const Pose& pose, const dvec3& axis) const;
    void lookTo(const dvec2& cursor);
    void zoomOrthographic(const dvec2& cursor, double factor);
    void place(const Pose& pose);
    void moveTo(Pose pose, const dvec3& from);

    struct MovedOut {
        Camera from, to;
    };

    Camera home_, camera_;
    Film film_;
    std::shared_ptr<const Bodies> bodies_;
    std::size_t target_;
    Pose pose_;
    bool home_is_outside_;               ///< of all ground, when the view began
    std::optional<MovedOut> moved_out_;  ///< by setBodies()
    // Of the drag:
    Pose grabbed_pose_;
    Raster grabbed_raster_;
    dvec2 grabbed_cursor_{0.0};
    dvec3 grabbed_point_{0.0};
    bool on_globe_ = false;
    bool looks_around_ = false;  ///< the sky was grabbed near the ground, or ground above the eye
};

}  // namespace dsphere::viewer
