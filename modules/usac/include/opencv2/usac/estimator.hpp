// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESTIMATOR_HPP
#define OPENCV_USACV20_ESTIMATOR_HPP

#ifndef OPENCV_BINDING_PARSER  // nothing here is for other languages

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief One estimation: points, parameters and the components that will do the work.

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
    @param points1 N points of image 1, as in #estimateHomography
    @param points2 their N counterparts in image 2
    @param params options
    @param cameraMatrix1 for #ESSENTIAL: 3x3 camera matrix of image 1
    @param cameraMatrix2 the same for image 2; empty: as image 1
    @param distCoeffs1 distortion of camera 1; empty: none
    @param distCoeffs2 distortion of camera 2; empty: none
    Raises cv::Exception for wrong arguments. */
    static Ptr<Usac> create(ProblemType problem, InputArray points1, InputArray points2,
                            const Params& params = Params(), InputArray cameraMatrix1 = noArray(),
                            InputArray cameraMatrix2 = noArray(),
                            InputArray distCoeffs1 = noArray(), InputArray distCoeffs2 = noArray());

    /** @brief The same for a problem of the caller's own, which the object keeps. Points have as
    many numbers as Problem::coordinates says; `points2` is noArray() where there is only one list.
    Points of 1 or 3 numbers: N rows or N columns of a matrix with 1 channel, or as many channels,
    any depth. */
    static Ptr<Usac> create(const Ptr<Problem>& problem, InputArray points1, InputArray points2,
                            const Params& params = Params());

    /** The components, to be replaced before #run. Those that nobody has replaced fit each other,
    whatever is replaced: a residual is also what models are fitted with. A component that is
    missing, a sampler that draws what is no sample and a score that counts no inliers end in a
    cv::Exception that names it. */
    virtual Components& components() = 0;
    //! The points as the components see them.
    virtual const Correspondences& points() const = 0;
    /** @brief Other points for the next #run, of any number, in the place of those of #create.
    @param points1, points2 as there. Params::scores, if there are any, are those of the new points:
    of the same number The object keeps its memory, as much as the largest run so far has needed: a
    tracker allocates once. After a cv::Exception it has no points. */
    virtual void setPoints(InputArray points1, InputArray points2) = 0;
    /** @brief Runs the estimation. May be called again, with the same result for the same points:
    Component::start tells all components, also those of the caller, that a run begins. From the
    second run of a size on only what is returned is allocated by this module (OpenCV allocates for
    kd-trees, for the cuts of graphs and for distortion).
    @param mask output, N x 1, CV_8U
    @param report output, may be null
    @return the model as #estimateHomography, #estimateFundamental or #estimateEssential return it,
    or the matrix of Problem::toInput, CV_64F; empty if there is none. */
    virtual Mat run(OutputArray mask = noArray(), Report* report = 0) = 0;

    /** @brief Least squares of the error over all points, or some: no search, what OpenCV calls
    method 0.
    @param weights N numbers of at least 0, any depth, of the squared errors; empty: all 1
    @param chosen N numbers, those of the points that take part are not 0 (a mask); empty: all
    @param mask output, N x 1, CV_8U, of all points, as of #run
    @param report output, may be null; `stop` is #STOP_NO_SEARCH, or says why there is no model
    @return the model as #run returns it; empty if the points determine none. It starts from the
    best models of minimal samples of the points and takes Gauss and Newton's method to its end.
    Wrong points pull at it as far as they are off. */
    virtual Mat fit(InputArray weights = noArray(), InputArray chosen = noArray(),
                    OutputArray mask = noArray(), Report* report = 0) = 0;
    /** @brief Makes a known model better.
    @param model as #run returns it, any depth
    @param chosen a mask of the inliers, N numbers: least squares over these, from the model; empty:
    the last step of #run, Params::polishing, from the model, with the inliers that it finds
    @param mask, report as of #fit
    @return the model; empty where the points determine none. */
    virtual Mat refine(InputArray model, InputArray chosen = noArray(),
                       OutputArray mask = noArray(), Report* report = 0) = 0;
    /** @brief The error of each point under a model, as the mask sees it: it is 1 exactly where
    this is at most Report::threshold.
    @param model as #run returns it, any depth
    @return N x 1, CV_64F, in the unit of Params::threshold, not squared. Not finite or NaN where
    there is none: points that are not finite, what is behind a camera or what its lens does not
    show. */
    virtual Mat errors(InputArray model) = 0;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
