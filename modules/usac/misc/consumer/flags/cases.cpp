// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Programs that would silently lose a flag or an option and therefore must not compile. A macro
// REFUSED_* selects one program. If MENDED is defined, too, the place marked with FLAG, FOCAL,
// SAMPLER or IN_NAMESPACE is changed and the program must compile, which shows that it is refused because of this place.
// Programs below a macro ALLOWED_* must compile unchanged.

#include <map>
#include <string>
#include <vector>
#include <opencv2/usac.hpp>

#ifdef MENDED
#define FLAG(flag) (int)flag  // an explicit conversion to a number
#define FOCAL(length) 1. * length
#define SAMPLER(number) (cv::usacv20::SamplerType)(number)
#define IN_NAMESPACE usacv20::
#else
#define FLAG(flag) flag
#define FOCAL(length) length
#define SAMPLER(number) number
#define IN_NAMESPACE
#endif

typedef std::vector<cv::Point2f> Points;
typedef std::vector<cv::Point3f> SpacePoints;

#if defined(REFUSED_variable)
cv::Mat estimate(const Points& a, const Points& b)
{
    int method = FLAG(cv::USACV20);
    return cv::findFundamentalMat(a, b, method, 1.0, 0.99);
}
#elif defined(REFUSED_settings)
struct Settings
{
    int method;
};
const Settings settings = {FLAG(cv::USACV20_MAGSAC)};
cv::Mat estimate(const Points& a, const Points& b)
{
    return cv::findHomography(a, b, settings.method);
}
#elif defined(REFUSED_map)
cv::Mat estimate(const Points& a, const Points& b, const std::string& name)
{
    std::map<std::string, int> methods;
    methods["ransac"] = cv::RANSAC;
    methods["usac"] = FLAG(cv::USACV20);
    return cv::findHomography(a, b, methods[name]);
}
#elif defined(REFUSED_default_argument)
cv::Mat estimate(const Points& a, const Points& b, int method = FLAG(cv::USACV20))
{
    return cv::findFundamentalMat(a, b, method);
}
#elif defined(REFUSED_argument)
cv::Mat estimate(const Points& a, const Points& b, int method);
cv::Mat accurate(const Points& a, const Points& b)
{
    return estimate(a, b, FLAG(cv::USACV20_ACCURATE));
}
#elif defined(REFUSED_ternary)
cv::Mat estimate(const Points& a, const Points& b, bool fast)
{
    return cv::findFundamentalMat(a, b, fast ? FLAG(cv::USACV20_FAST) : cv::RANSAC);
}
#elif defined(REFUSED_affine)
cv::Mat estimate(const Points& a, const Points& b)
{
    const int method = FLAG(cv::USACV20);
    return cv::estimateAffinePartial2D(a, b, cv::noArray(), method);
}
#elif defined(REFUSED_affine_both_namespaces)
using namespace cv;
using namespace cv::usacv20;
cv::Mat estimate(const Points& a, const Points& b, int method)
{
    return IN_NAMESPACE estimateAffine2D(a, b, noArray(), method);
}
#elif defined(REFUSED_pose)
bool estimate(const SpacePoints& a, const Points& b, const cv::Mat& K, cv::Mat& r, cv::Mat& t)
{
    const int flags = FLAG(cv::USACV20);
    return cv::solvePnPRansac(a, b, K, cv::noArray(), r, t, false, 100, 8, 0.99, cv::noArray(),
                              flags);
}
#elif defined(REFUSED_pose_ternary)
bool estimate(const SpacePoints& a, const Points& b, const cv::Mat& K, cv::Mat& r, cv::Mat& t,
              bool fast)
{
    return cv::solvePnPRansac(a, b, K, cv::noArray(), r, t, false, 100, 8, 0.99, cv::noArray(),
                              fast ? FLAG(cv::USACV20_FAST) : cv::SOLVEPNP_P3P);
}
#elif defined(REFUSED_pose_both_namespaces)
using namespace cv;
using namespace cv::usacv20;
bool estimate(const SpacePoints& a, const Points& b, const Mat& K, Mat& r, Mat& t, int flags)
{
    return IN_NAMESPACE solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, noArray(),
                                       flags);
}
#elif defined(REFUSED_or)
cv::Mat estimate(const Points& a, const Points& b)
{
    return cv::findFundamentalMat(a, b, FLAG(cv::USACV20) | cv::RANSAC);
}
#elif defined(REFUSED_focal_length)
// The camera matrix is missing, so the flag would be used as the focal length.
cv::Mat estimate(const Points& a, const Points& b)
{
    return cv::findEssentialMat(a, b, FLAG(cv::USACV20));
}
#elif defined(REFUSED_focal_length_at_run_time)
cv::Mat estimate(const Points& a, const Points& b, int method)
{
    return cv::usacv20::findEssentialMat(a, b, FOCAL(method));
}
#elif defined(REFUSED_both_namespaces)
using namespace cv;
using namespace cv::usacv20;
cv::Mat estimate(const Points& a, const Points& b, int method)
{
    return IN_NAMESPACE findFundamentalMat(a, b, method);
}
#elif defined(REFUSED_enumerator_of_another_field)
void choose(cv::usacv20::Params& params) { params.sampler = SAMPLER(cv::usacv20::QUALITY_MSAC); }
#elif defined(REFUSED_number_of_an_enumerator)
void choose(cv::usacv20::Params& params, int number) { params.sampler = SAMPLER(number); }

#elif defined(ALLOWED_namespace_cv)
using namespace cv;
Mat estimate(const Points& a, const Points& b, const Mat& K, Mat& mask, int method)
{
    usacv20::Params params = usacv20::Params::fromMethod(USACV20_FAST);
    params = usacv20::Params::fromMethod(method);
    const UsacV20Method flag = method ? USACV20_MAGSAC : USACV20;
    return findHomography(a, b, USACV20, 3, mask) + findHomography(a, b, mask, params) +
           findHomography(a, b, method) + findFundamentalMat(a, b, mask, flag) +
           findFundamentalMat(a, b, mask, params) + findFundamentalMat(a, b) +
           findEssentialMat(a, b, K, flag) +
           findEssentialMat(a, b, K, K, noArray(), noArray(), mask, params) +
           findEssentialMat(a, b, 800, Point2d(320, 240), flag) +
           findEssentialMat(a, b, K, RANSAC) + estimateAffine2D(a, b, mask, flag) +
           estimateAffine2D(a, b, mask, params) + estimateAffine2D(a, b) +
           estimateAffinePartial2D(a, b, mask, flag, 2, 100) +
           estimateAffinePartial2D(a, b, mask, params) +
           estimateAffinePartial2D(a, b, mask, RANSAC);
}
#elif defined(ALLOWED_both_namespaces)
using namespace cv;
using namespace cv::usacv20;
Mat estimate(const Points& a, const Points& b, const Mat& K, Mat& mask, int method)
{
    const Params params = Params::accurate();
    const double threshold = 1;
    return findHomography(a, b, USACV20, threshold, mask) + findHomography(a, b, mask, params) +
           findFundamentalMat(a, b, USACV20_FAST, 1, 0.99, 500) +
           findFundamentalMat(a, b, mask, params) + findEssentialMat(a, b, K, USACV20) +
           findEssentialMat(a, b, K, USACV20, 0.999, threshold, mask) +
           usacv20::findHomography(a, b, method) +
           usacv20::findHomography(a, b, USACV20, 2, mask, 100) +
           estimateAffine2D(a, b, mask, USACV20, threshold) + estimateAffine2D(a, b, mask, params) +
           usacv20::estimateAffine2D(a, b, mask, method) +
           estimateAffinePartial2D(a, b, noArray(), USACV20_FAST);
}
#elif defined(ALLOWED_pose_namespace_cv)
using namespace cv;
int estimate(const SpacePoints& a, const Points& b, Mat& K, Mat& r, Mat& t,
             std::vector<int>& inliers, int flags)
{
    const UsacV20Method method = flags ? USACV20_ACCURATE : USACV20;
    const usacv20::Params params = usacv20::Params::fromMethod(flags);
    return solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, USACV20) +
           solvePnPRansac(a, b, K, K, r, t, true, 100, 8.f, 0.99, noArray(), method) +
           solvePnPRansac(a, b, K, noArray(), r, t, inliers, params) +
           solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, flags) +
           solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, SOLVEPNP_EPNP) +
           solvePnPRansac(a, b, K, noArray(), r, t, inliers, UsacParams()) +
           solvePnPRansac(a, b, K, noArray(), r, t, inliers) +
           solvePnPRansac(a, b, K, noArray(), r, t, true, 50) +
           solvePnPRansac(a, b, K, noArray(), r, t);
}
#elif defined(ALLOWED_pose_both_namespaces)
using namespace cv;
using namespace cv::usacv20;
int estimate(const SpacePoints& a, const Points& b, const Mat& K, Mat& r, Mat& t,
             std::vector<int>& inliers, int flags)
{
    const Params params = Params::fast();
    const UsacV20Method method = USACV20_MAGSAC;
    return solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, USACV20) +
           solvePnPRansac(a, b, K, noArray(), r, t, true, 100, 8, 0.99, noArray(), method) +
           solvePnPRansac(a, b, K, noArray(), r, t, inliers, params) +
           usacv20::solvePnPRansac(a, b, K, K, r, t) +
           usacv20::solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, flags) +
           usacv20::solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, method) +
           cv::solvePnPRansac(a, b, K, noArray(), r, t, false, 100, 8, 0.99, inliers, flags);
}
#else
#error no such case
#endif
