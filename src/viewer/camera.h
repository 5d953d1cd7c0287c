#pragma once

#include "render/raster.h"
#include "viewer/globe.h"

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

/// The camera as the mouse and keys move it. Cursor positions are pixels of the film, y downward. Drags go from where
/// the cursor grabbed, never from the last event, so nothing drifts.
class CameraControl {
  public:
    /// The nearest that the eye comes to the ground and the farthest from it, in R.
    static constexpr double kLowest = 1e-3, kHighest = 1e6;

    CameraControl(const Camera& camera, const Film& film, const Globe& globe);

    const Camera& camera() const { return camera_; }
    double altitude() const { return globe_.altitude(pose_.eye); }
    CursorRay rayAt(const dvec2& cursor) const;

    void resize(int width, int height);
    void setGlobe(const Globe& globe);
    void setCamera(const Camera& camera);
    /// Back to where it started.
    void reset();
    /// The whole globe from '1' latitude 0, longitude 0; '3' longitude 90; '7' the north pole; '9' between those.
    void axisView(int key);

    /// Starts a drag; `hit` is the world point under the cursor, if any.
    void grab(const dvec2& cursor, const std::optional<dvec3>& hit);
    /// Turns the globe: the grabbed ground stays under the cursor, north stays as far up as it was.
    void orbitTo(const dvec2& cursor);
    /// Moves sideways: what was grabbed stays under the cursor.
    void panTo(const dvec2& cursor);
    /// Turns about what was grabbed: its vertical, and up to the horizon.
    void tiltTo(const dvec2& cursor);

    /// Towards (steps > 0) or away from what is under the cursor, which stays there.
    void zoom(const dvec2& cursor, const std::optional<dvec3>& hit, double steps);
    /// Along the camera's axes (right, up, ahead), each -1 to 1, for some seconds; as fast as the eye is high.
    void fly(const dvec3& along, double seconds);

  private:
    dvec3 pivot(const dvec2& cursor, const std::optional<dvec3>& hit) const;
    std::optional<dvec3> onSphere(const CursorRay& ray, double radius) const;
    dmat3 levelling(const Pose& pose, const dvec3& axis) const;
    void zoomOrthographic(const dvec2& cursor, double factor);
    void place(const Pose& pose);
    void keepAboveGround(Pose& pose) const;
    void limit(Pose& pose, const dvec3& from) const;

    Camera home_, camera_;
    Film film_;
    Globe globe_;
    Pose pose_;
    // Of the drag:
    Pose grabbed_pose_;
    Raster grabbed_raster_;
    dvec2 grabbed_cursor_{0.0};
    dvec3 grabbed_point_{0.0};
    bool on_globe_ = false;
};

}  // namespace dsphere::viewer
