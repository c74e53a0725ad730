// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESSENTIAL_MOTION_HPP
#define OPENCV_USACV20_ESSENTIAL_MOTION_HPP

#include "opencv2/usac/estimator.hpp"
#include "problems/essential/motions.hpp"

namespace cv {
namespace usacv20 {

//! Selects, from the four motions of an essential matrix, the motion with the largest number of
//! matches in front of both cameras. Of many matches, only some are used.
//! @param x1, x2 matches on the normalized image planes, homogeneous
//! @param limit threshold of inFront()
Motion motionInFront(const Matx33d& essential, const std::vector<Vec3d>& x1,
                     const std::vector<Vec3d>& x2, double limit);

//! An essential matrix with its inliers and its motion.
struct EssentialMotion
{
    Mat essential, mask;
    Report report;  //!< of the search or refinement that found the essential matrix
    Motion motion;
    double threshold;  //!< threshold of the mask
    int inliers;       //!< inliers of the essential matrix, including points behind a camera
    double cost;       //!< sum of squared errors, in squared thresholds; a point counts as 1 if it
                       //!< is an outlier or not in front of both cameras
};

//! Makes `best` the motion with the lower cost, with a report on the search. `other` may be empty.
void preferCheaper(EssentialMotion& best, EssentialMotion& other);

//! The motions of two calibrated views.
class EssentialMotions
{
public:
    //! @param usac an estimator of the essential matrix, with the matches of the views
    explicit EssentialMotions(const Ptr<Usac>& usac);

    //! Computes the members that follow from `essential` and the threshold. For results of
    //! refinements, this is the threshold of the search: a threshold estimated in the refinement
    //! could differ, and the two motions of a plane are comparable only with the same threshold.
    void read(EssentialMotion& found, double threshold) const;
    /** @brief Finds the second motion that explains the matches of a plane.
    @param found the motion found by a search
    @param H homography of the plane from image plane 1 to image plane 2
    @param point image of a point of the plane on image plane 1, homogeneous
    @param other output; its `essential` is empty if a fit that starts from the second motion leads
    to `found`
    @return false if the homography does not determine two motions */
    bool otherOfPlane(const EssentialMotion& found, const Matx33d& H, const Vec3d& point,
                      EssentialMotion& other) const;
    //! Inlier threshold on the normalized image planes.
    double limit(const EssentialMotion& motion) const
    {
        return usac->points().unit * motion.threshold;
    }
    //! True if a match is in front of both cameras.
    bool seen(const EssentialMotion& motion, int row) const
    {
        return inFront(motion.motion, x1[row], x2[row], limit(motion));
    }

    const Ptr<Usac> usac;
    std::vector<Vec3d> x1, x2;  //!< undistorted points on the normalized image planes; NaN for
                                //!< matches that are not finite
};

}  // namespace usacv20
}  // namespace cv

#endif
