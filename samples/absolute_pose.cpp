// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Finds the pose of a camera from an image of a flat object and one or two scenes that contain the
// object. Points of the object's image become 3-D points (Z = 0), and their matches in the scene
// are the image points. cv::solvePnPRansac and usacv20::estimateAbsolutePose find the pose, and the
// axes of the object are drawn into the scene. The pose in the first scene is the initial model in
// the second. Without images, a synthetic board and two photographs of it are made, and the true
// poses are known.

#include <opencv2/usac/geometry.hpp>
#include "tools.hpp"

namespace {

struct Camera
{
    cv::Mat matrix, distortion;
};

//! An image that contains the object, and the true pose [R t], which is empty if it is unknown.
struct Scene
{
    cv::Mat image, truth;
};

//! Converts pixels of the object's image to 3-D points. The origin is the middle of the
//! object, X points to the right, Y up, Z to the viewer; the object is 1 wide.
std::vector<cv::Point3f> placesInSpace(const std::vector<cv::Point2f>& pixels, cv::Size object)
{
    std::vector<cv::Point3f> places;
    for (size_t i = 0; i < pixels.size(); ++i)
        places.push_back(cv::Point3f((pixels[i].x - 0.5f * object.width) / object.width,
                                     (0.5f * object.height - pixels[i].y) / object.width, 0));
    return places;
}

//! Reads a camera from a file as OpenCV's calibration sample writes it. Without a file, assumes the
//! focal length of the option `focal`, or a typical one if this is 0, and no distortion.
Camera readCamera(const cv::CommandLineParser& parser, cv::Size size)
{
    Camera camera;
    const std::string file = parser.get<std::string>("camera");
    if (file.empty())
    {
        const double focal = parser.get<double>("focal"),
                     f = focal > 0 ? focal : 1.2 * std::max(size.width, size.height);
        const double cx = 0.5 * (size.width - 1), cy = 0.5 * (size.height - 1);
        camera.matrix = cv::Mat_<double>({3, 3}, {f, 0, cx, 0, f, cy, 0, 0, 1});
        return camera;
    }
    const cv::FileStorage fs(tools::findFile(file), cv::FileStorage::READ);
    fs["camera_matrix"] >> camera.matrix;
    fs["distortion_coefficients"] >> camera.distortion;
    if (camera.matrix.empty())
        CV_Error(cv::Error::StsError, file + ": no camera_matrix");
    return camera;
}

cv::Mat poseOf(const cv::Mat& rvec, const cv::Mat& tvec)
{
    cv::Mat rotation, pose;
    cv::Rodrigues(rvec, rotation);
    cv::hconcat(rotation, tvec, pose);
    return pose;
}

//! An image with features everywhere: noise of three sizes.
cv::Mat texture(cv::Size size, int seed)
{
    cv::RNG rng(seed);
    cv::Mat sum(size, CV_32FC3, cv::Scalar::all(0)), image;
    for (int step = 4; step <= 40; step *= 3)
    {
        cv::Mat noise(size.height / step + 2, size.width / step + 2, CV_32FC3);
        rng.fill(noise, cv::RNG::UNIFORM, -1, 1);
        cv::resize(noise, noise, size, 0, 0, cv::INTER_CUBIC);
        sum += noise;
    }
    cv::normalize(sum, image, 0, 255, cv::NORM_MINMAX, CV_8U);
    return image;
}

//! Adds the lens distortion to the image of a pinhole camera.
cv::Mat distort(const cv::Mat& image, const Camera& camera)
{
    if (camera.distortion.empty())
        return image;
    std::vector<cv::Point2f> pixels, places;
    for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
            pixels.push_back(cv::Point2f((float)x, (float)y));
    cv::undistortPoints(pixels, places, camera.matrix, camera.distortion, cv::noArray(),
                        camera.matrix);
    cv::Mat result;
    cv::remap(image, result, cv::Mat(places).reshape(2, image.rows), cv::noArray(),
              cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return result;
}

//! Renders the board as seen from a pose, partly occluded and in front of a background.
Scene photograph(const cv::Mat& board, const cv::Vec3d& rvec, const cv::Vec3d& tvec, int seed,
                 const cv::CommandLineParser& parser)
{
    const cv::Size size(640, 480);
    const Camera camera = readCamera(parser, size);
    const std::vector<cv::Point2f> corners = {cv::Point2f(0, 0), cv::Point2f((float)board.cols, 0),
                                              cv::Point2f((float)board.cols, (float)board.rows),
                                              cv::Point2f(0, (float)board.rows)};
    std::vector<cv::Point2f> seen;
    cv::projectPoints(placesInSpace(corners, board.size()), rvec, tvec, camera.matrix,
                      cv::noArray(), seen);
    Scene scene;
    scene.truth = poseOf(cv::Mat(rvec), cv::Mat(tvec));
    scene.image = texture(size, seed);
    cv::warpPerspective(board, scene.image, cv::getPerspectiveTransform(corners, seen), size,
                        cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
    scene.image = distort(scene.image, camera);
    board(cv::Rect(0, 0, 120, 160))
        .copyTo(scene.image(cv::Rect(20, 300, 120, 160)));  // causes wrong, but consistent matches
    texture(cv::Size(160, 140), seed + 1).copyTo(scene.image(cv::Rect(260, 150, 160, 140)));
    return scene;
}

//! Angle of the rotation between two poses, in degrees.
double angleBetween(const cv::Mat& a, const cv::Mat& b)
{
    cv::Mat between;
    cv::Rodrigues(a.colRange(0, 3).t() * b.colRange(0, 3), between);
    return cv::norm(between) * 180 / CV_PI;
}

//! The input of all methods.
struct Input
{
    std::vector<cv::Point3f> objectPoints;
    std::vector<cv::Point2f> imagePoints;
    Camera camera;
};

//! Estimates the pose like a typical program. `Flag` is the type of the flags of OpenCV or of the
//! flags of this module.
template <class Flag>
tools::Result estimate(const char* name, Flag flag, const Input& in, const tools::Settings& s)
{
    return tools::measure(name, s.runs, [&](cv::Mat& mask) {
        cv::Mat rvec, tvec;
        std::vector<int> inliers;
        const bool found = cv::solvePnPRansac(
            in.objectPoints, in.imagePoints, in.camera.matrix, in.camera.distortion, rvec, tvec,
            false, s.maxIterations, (float)s.threshold, s.confidence, inliers, flag);
        mask = cv::Mat((int)in.imagePoints.size(), 1, CV_8U, cv::Scalar(0));
        for (size_t i = 0; i < inliers.size(); ++i)
            mask.at<uchar>(inliers[i]) = 1;
        return found ? poseOf(rvec, tvec) : cv::Mat();
    });
}

//! Estimates the pose with options that a flag does not have: the scores of the matches and, as
//! initial model, the pose `before` in the previous scene, unless it is empty.
tools::Result estimateWith(const char* name, const Input& in, const tools::Matches& matches,
                           const cv::Mat& before, const tools::Settings& s)
{
    cv::usacv20::Params params = s.params();
    params.covariance = 1;
    params.scores.assign(matches.ratios.begin(), matches.ratios.end());
    params.setInitialModel(before);
    cv::usacv20::Report report;
    tools::Result result = tools::measure(name, s.runs, [&](cv::Mat& mask) {
        return cv::usacv20::estimateAbsolutePose(in.objectPoints, in.imagePoints, in.camera.matrix,
                                                 in.camera.distortion, params, mask, report);
    });
    result.iterations = report.iterations;
    std::cout << name << ": " << report.describe() << std::endl;
    if (!report.covariance.empty())
    {
        const cv::Mat variances = report.covariance.diag();
        std::cout << cv::format("  one sigma: rotation %.3f %.3f %.3f degrees, translation %.5f "
                                "%.5f %.5f; noise of the matches %.2f px",
                                std::sqrt(variances.at<double>(0)) * 180 / CV_PI,
                                std::sqrt(variances.at<double>(1)) * 180 / CV_PI,
                                std::sqrt(variances.at<double>(2)) * 180 / CV_PI,
                                std::sqrt(variances.at<double>(3)),
                                std::sqrt(variances.at<double>(4)),
                                std::sqrt(variances.at<double>(5)), report.sigma)
                  << std::endl;
    }
    return result;
}

//! Draws the matches, and the axes and the outline of the object.
cv::Mat draw(const cv::Mat& object, const Scene& scene, const tools::Matches& matches,
             const tools::Result& result, const Camera& camera)
{
    cv::Mat canvas = tools::drawInliers(object, scene.image, matches, result.mask, 30);
    cv::Mat right = canvas(cv::Rect(cv::Point(object.cols, 0), scene.image.size())), rvec;
    const cv::Mat tvec = result.model.col(3);
    cv::Rodrigues(result.model.colRange(0, 3), rvec);
    const float w = (float)object.cols, h = (float)object.rows;
    std::vector<cv::Point2f> corners = {cv::Point2f(0, 0), cv::Point2f(w, 0), cv::Point2f(w, h),
                                        cv::Point2f(0, h)};
    cv::projectPoints(placesInSpace(corners, object.size()), rvec, tvec, camera.matrix,
                      camera.distortion, corners);
    for (int k = 0; k < 4; ++k)
        cv::line(right, corners[k], corners[(k + 1) % 4], cv::Scalar(0, 140, 255), 2, cv::LINE_AA);
    cv::drawFrameAxes(right, camera.matrix, camera.distortion, rvec, tvec, 0.4f, 3);
    return canvas;
}

/** Prints the table of a scene and draws the scene.
@param before input: pose in the previous scene, or empty; output: pose in this scene, empty if it
is not found
@param pictures output; the drawing is appended
@return the exit code */
int findPose(const cv::Mat& object, const Scene& scene, const cv::CommandLineParser& parser,
             cv::Mat& before, std::vector<cv::Mat>& pictures)
{
    const tools::Settings settings(parser, parser.get<int>("iterations"));
    const tools::Matches matches = tools::match(object, scene.image, parser);
    Input in;
    in.objectPoints = placesInSpace(matches.points1, object.size());
    in.imagePoints = matches.points2;
    in.camera = readCamera(parser, scene.image.size());
    std::vector<tools::Result> results;
    results.push_back(estimate("ITERATIVE", cv::SOLVEPNP_ITERATIVE, in, settings));
    results.push_back(estimate("USAC_DEFAULT", cv::USAC_DEFAULT, in, settings));
    results.push_back(estimate("USACV20", cv::USACV20, in, settings));
    results.push_back(estimateWith("with scores", in, matches, cv::Mat(), settings));
    if (!before.empty())
        results.push_back(estimateWith("with the last", in, matches, before, settings));
    for (size_t i = 0; i < results.size(); ++i)
        if (!scene.truth.empty() && !results[i].model.empty())
        {
            results[i].error = angleBetween(results[i].model, scene.truth);
            results[i].errorText = cv::format(
                "%.2f deg, %.4f", results[i].error,
                cv::norm(results[i].model.col(3), scene.truth.col(3)));
        }
    std::cout << "error: angle between the rotations; |t - true t|, in widths of the object"
              << std::endl;
    tools::printTable(matches, results, settings.runs);
    const tools::Result& ours = results.back();
    before = ours.model;
    if (!ours.model.empty())
    {
        std::cout << "[R t] = " << ours.model << std::endl << std::endl;
        pictures.push_back(draw(object, scene, matches, ours, in.camera));
    }
    return tools::exitCode(ours, 1);
}

int sample(const cv::CommandLineParser& parser)
{
    cv::Mat object;
    std::vector<Scene> scenes;
    if (parser.get<std::string>("@object").empty())
    {
        object = texture(cv::Size(400, 300), 1);
        scenes.push_back(
            photograph(object, cv::Vec3d(2.7, 0.3, -0.5), cv::Vec3d(0.1, 0.02, 2), 2, parser));
        scenes.push_back(
            photograph(object, cv::Vec3d(2.68, 0.34, -0.47), cv::Vec3d(0.13, 0, 2.05), 4, parser));
    }
    else
    {
        object = tools::readImage(parser.get<std::string>("@object"));
        scenes.resize(parser.get<std::string>("@next").empty() ? 1 : 2);
        for (size_t i = 0; i < scenes.size(); ++i)
            scenes[i].image = tools::readImage(
                parser.get<std::string>(i == 0 ? "@scene" : "@next"));
    }
    cv::Mat pose, picture;
    std::vector<cv::Mat> pictures;
    int code = 0;
    for (size_t i = 0; i < scenes.size(); ++i)
        code |= findPose(object, scenes[i], parser, pose, pictures);
    int width = 0;
    for (size_t i = 0; i < pictures.size(); ++i)
        width = std::max(width, pictures[i].cols);
    for (size_t i = 0; i < pictures.size(); ++i)
        cv::copyMakeBorder(pictures[i], pictures[i], 0, 0, 0, width - pictures[i].cols,
                           cv::BORDER_CONSTANT, cv::Scalar::all(255));
    if (!pictures.empty())
    {
        cv::vconcat(pictures, picture);
        tools::writePicture(parser, picture,
                            "green: inliers, some joined; axes: X red, Y green, Z blue");
    }
    return code;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string
        keys = "{help h usage ? |                   | print this help}"
               "{@object        |                   | image of a flat object, such as box.png; "
               "none: a synthetic board and two photographs of it are made}"
               "{@scene         | box_in_scene.png  | image with the object in it}"
               "{@next          |                   | image of the scene a moment later; the pose "
               "in the first scene is its initial model}"
               "{camera         |                   | file with camera_matrix and "
               "distortion_coefficients; none: no distortion; for the focal length, see `focal`}"
               "{focal          | 0                 | focal length in pixels, without `camera`; 0: "
               "1.2 times the longer side of the image}"
               "{threshold      | 2                 | inlier threshold in pixels}"
               "{iterations     | 2000              | largest number of samples}"
               "{ratio          | 0.8               | largest ratio of the descriptor distances "
               "of the best and the second best match}"
               "{features       | 8000              | largest number of features per image}"
               "{confidence     | 0.99              | probability of finding the best model}"
               "{runs           | 11                | number of runs; the median time is printed}"
               "{width          | 1400              | largest width of the picture}"
               "{output o       | absolute_pose.jpg | picture to write}";
    return tools::runSample(argc, argv, keys, "Pose of a camera from the image of a flat object.",
                            sample);
}
