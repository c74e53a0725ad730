// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESTIMATOR_HPP
#define OPENCV_USACV20_ESTIMATOR_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @brief One estimation: the points, the options and the components.

@code
    Ptr<usacv20::Usac> usac = usacv20::Usac::create(usacv20::HOMOGRAPHY, points1, points2, params);
    usac->components().sampler = makePtr<MySampler>();
    Mat mask, H = usac->run(mask);
@endcode
*/
class CV_EXPORTS Usac
{
public:
    virtual ~Usac();

    /** @brief Reads the points and builds the components that `params` names.
    @param problem what to estimate
    @param points1 N points of image 1 (#ABSOLUTE_POSE, 3-D motions: 3-D points), as in
    #estimateHomography and similar functions
    @param points2 their N counterparts in image 2
    @param params options
    @param cameraMatrix1 for #ESSENTIAL and #ABSOLUTE_POSE: 3x3 camera matrix of image 1
    @param cameraMatrix2 for #ESSENTIAL: 3x3 camera matrix of image 2; empty: that of image 1
    @param distCoeffs1 for #ESSENTIAL and #ABSOLUTE_POSE: distortion of camera 1; empty: none
    @param distCoeffs2 for #ESSENTIAL: distortion of camera 2; empty: none

    Raises cv::Exception for invalid arguments. */
    static Ptr<Usac> create(ProblemType problem, InputArray points1, InputArray points2,
                            const Params& params = Params(), InputArray cameraMatrix1 = noArray(),
                            InputArray cameraMatrix2 = noArray(),
                            InputArray distCoeffs1 = noArray(), InputArray distCoeffs2 = noArray());

    /** @brief The same for a problem of your own; the object keeps the pointer. The number of
    coordinates per point is Problem::coordinates; `points2` is noArray() if there is only one
    array. Points with 2 coordinates: as in #estimateHomography; with 1 or 3: N rows or N columns of
    a matrix with 1 channel, or a matrix with as many channels as coordinates, any depth. */
    static Ptr<Usac> create(const Ptr<Problem>& problem, InputArray points1, InputArray points2,
                            const Params& params = Params());

    /** The components, which can be replaced before #run. The remaining default components adapt to
    a replaced one: for example, fits minimize the new residual. In #run, a missing required
    component, a sampler that draws invalid samples, or a score that does not count points without
    error as inliers raises a cv::Exception that names the component. */
    virtual Components& components() = 0;
    //! The points as the components see them.
    virtual const Correspondences& points() const = 0;
    /** @brief Replaces the points of #create for the next #run; their number can differ.
    @param points1, points2 as in #create. Params::scores and Params::sigmas, if any, are used for
    the new points, whose number must then be the same.

    The object keeps the memory that its largest run so far needed, so that a tracker allocates only
    once. After a cv::Exception the object has no points. */
    virtual void setPoints(InputArray points1, InputArray points2) = 0;
    /** @brief Runs the estimation. Can be called repeatedly, with the same result for the same
    points: each run begins with Component::start of all components, including replaced ones. From
    the second run of the same size on, this module allocates memory only for its results (OpenCV
    allocates some for kd-trees, graph cuts and distortion).
    @param mask output, N x 1, CV_8U
    @param report output, can be null
    @return the model in the form of #estimateHomography and similar functions; for other problems
    the matrix of Problem::toOutput, CV_64F; empty if there is none. */
    virtual Mat run(OutputArray mask = noArray(), Report* report = 0) = 0;

    /** @brief Least-squares fit to all points, or to a subset, without a search, as with the flag 0
    of calib3d.
    @param weights N finite weights of the squared errors, at least 0, any depth; empty: all 1
    @param chosen mask of the points to fit, N numbers, 0 for points that are left out; empty: all
    points
    @param mask output, N x 1, CV_8U, for all points, as in #run
    @param report output, can be null; `stop` is #STOP_NO_SEARCH, the reason why there is no
    model, or #STOP_TIME or #STOP_CANCELLED if the fit ended early
    @return the model as #run returns it; empty if the points determine none. The fit starts from
    the best models of minimal samples and iterates the Gauss-Newton method until it converges. It
    is not robust: outliers affect it fully. */
    virtual Mat fit(InputArray weights = noArray(), InputArray chosen = noArray(),
                    OutputArray mask = noArray(), Report* report = 0) = 0;
    /** @brief Refines a known model.
    @param model as #run returns it, any depth
    @param chosen mask of the inliers, N numbers, 0 for other points. With a mask, a least-squares
    fit to these inliers is made, starting from the model. Empty: the model is polished as at the
    end of #run (Params::polishing); the polishing selects the inliers itself
    @param mask, report as in #fit
    @return the model; empty if the points determine none. */
    virtual Mat refine(InputArray model, InputArray chosen = noArray(),
                       OutputArray mask = noArray(), Report* report = 0) = 0;
    /** @brief The error of each point under a model. The mask is 1 exactly where the error is at
    most Report::threshold.
    @param model as #run returns it, any depth
    @return N x 1, CV_64F, in the unit of Params::threshold, not squared. Infinite or NaN where the
    error is not defined: for points that are not finite, outside the field of view of a lens, or
    (absolute pose) behind the camera. */
    virtual Mat errors(InputArray model) = 0;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
