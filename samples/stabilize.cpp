// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Stabilizes a sequence: estimates the similarity from each frame to the next with
// cv::usacv20::estimateAffinePartial2D, replaces the shaky path of the camera by a smooth path, and
// moves each frame onto the smooth path. The frames are the images of a folder. Without a folder,
// the frames are windows of an image along a shaky path, with an independently moving patch in
// front, and the true motions are known.

#include "tools.hpp"

namespace {

//! Frames and, if known, the true motions from each frame to the next.
struct Sequence
{
    std::vector<cv::Mat> frames;
    std::vector<cv::Matx23d> truth;
};

cv::Matx33d square(const cv::Matx23d& m)
{
    return cv::Matx33d(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), 0, 0, 1);
}

cv::Matx23d rows(const cv::Matx33d& m) { return cv::Matx23d(m.val); }

//! Rotation and scaling about a center, followed by a shift.
cv::Matx23d motion(cv::Point2d center, double degrees, double scale, cv::Point2d shift)
{
    cv::Matx23d m;
    cv::getRotationMatrix2D(center, degrees, scale).copyTo(m);
    m(0, 2) += shift.x;
    m(1, 2) += shift.y;
    return m;
}

Sequence readFolder(const std::string& folder)
{
    std::vector<cv::String> files;
    cv::glob(folder, files);  // returns sorted names
    Sequence sequence;
    for (size_t i = 0; i < files.size(); ++i)
    {
        const cv::Mat frame = cv::imread(files[i]);
        if (frame.empty() ||
            (!sequence.frames.empty() && frame.size() != sequence.frames[0].size()))
            std::cerr << files[i] << ": left out: not an image of the size of the first one"
                      << std::endl;
        else
            sequence.frames.push_back(frame);
    }
    return sequence;
}

//! Simulates a hand-held camera: frames are windows of the image, with a patch in front that moves
//! independently.
Sequence shaken(const cv::Mat& image, int count)
{
    const cv::Size size(image.cols * 5 / 8, image.rows * 5 / 8),
        patch(size.width * 2 / 5, size.height / 2);
    const cv::Point2d middle(image.cols / 2., image.rows / 2.),
        corner(-image.cols * 3 / 16., -image.rows * 3 / 16.);
    cv::RNG rng(1);
    Sequence sequence;
    std::vector<cv::Matx33d> windows;
    for (int k = 0; k < count; ++k)
    {
        const cv::Point2d shake(rng.gaussian(6), rng.gaussian(6));
        windows.push_back(
            square(motion(middle, rng.gaussian(1.5), 1 + rng.gaussian(0.01), corner + shake)));
        cv::Mat frame;
        cv::warpAffine(image, frame, rows(windows[k]), size, cv::INTER_LINEAR, cv::BORDER_REFLECT);
        const cv::Point place(k * (size.width - patch.width) / std::max(count - 1, 1),
                              size.height / 4);
        image(cv::Rect(cv::Point(image.cols - patch.width, 0), patch))
            .copyTo(frame(cv::Rect(place, patch)));
        sequence.frames.push_back(frame);
        if (k > 0)
            sequence.truth.push_back(rows(windows[k] * windows[k - 1].inv()));
    }
    return sequence;
}

//! Mean distance, in pixels, between the corners of a frame moved by motion `a` and the same
//! corners moved by motion `b`.
double distance(const cv::Matx23d& a, const cv::Matx23d& b, cv::Size size)
{
    double sum = 0;
    for (int k = 0; k < 4; ++k)
        sum += cv::norm((a - b) * cv::Vec3d(k % 2 * size.width, k / 2 * size.height, 1)) / 4;
    return sum;
}

//! Estimates the motion from each frame to the next with one method and prints the line of this
//! method in the table. A motion that is not found is replaced by the identity. @return false if
//! there is such a motion
bool estimate(const char* name, int method, const Sequence& sequence,
              const std::vector<tools::Matches>& matches, const tools::Settings& s,
              std::vector<cv::Matx23d>& motions, double& meanError)
{
    double milliseconds = 0, worst = 0;
    int inliers = 0, all = 0, lost = 0;
    motions.assign(matches.size(), cv::Matx23d(1, 0, 0, 0, 1, 0));
    meanError = 0;
    for (size_t k = 0; k < matches.size(); ++k)
    {
        const tools::Result result = tools::measure(name, s.runs, [&](cv::Mat& mask) {
            return cv::usacv20::estimateAffinePartial2D(matches[k].points1, matches[k].points2,
                                                        mask, method, s.threshold, s.maxIterations,
                                                        s.confidence);
        });
        lost += result.model.empty();
        if (!result.model.empty())
            motions[k] = cv::Matx23d(result.model.ptr<double>());
        milliseconds += result.milliseconds;
        inliers += result.mask.empty() ? 0 : cv::countNonZero(result.mask);
        all += (int)matches[k].points1.size();
        const double error = sequence.truth.empty() ? 0
                                                    : distance(motions[k], sequence.truth[k],
                                                               sequence.frames[0].size());
        meanError += error / matches.size();
        worst = std::max(worst, error);
    }
    const std::string errors = sequence.truth.empty()
                                   ? "unknown"
                                   : cv::format("%.3f, %.3f px", meanError, worst);
    std::cout << cv::format("%-10s %-18s %11.1f %6d %11.3f\n", name, errors.c_str(),
                            100. * inliers / std::max(all, 1), lost, milliseconds / matches.size());
    return lost == 0;
}

/** Returns the transformations that move each frame onto the smooth path. The path of the camera
consists of the position of the frame's middle (x, y), the angle and the log scale; the smooth path
consists of their moving averages, each over the frame itself and `radius` frames before and after
it. */
std::vector<cv::Matx23d> corrections(const std::vector<cv::Matx23d>& motions, cv::Size size,
                                     int radius)
{
    const cv::Vec3d middle(size.width / 2., size.height / 2., 1);
    std::vector<cv::Vec4d> path(1, cv::Vec4d());
    cv::Matx33d toFirst = cv::Matx33d::eye();
    for (size_t k = 0; k < motions.size(); ++k)
    {
        toFirst = toFirst * square(motions[k]).inv();
        const cv::Vec3d place = toFirst * middle - middle;
        path.push_back(cv::Vec4d(place[0], place[1], std::atan2(toFirst(1, 0), toFirst(0, 0)),
                                 0.5 * std::log(determinant(toFirst))));
    }
    std::vector<cv::Matx23d> result;
    for (int k = 0; k < (int)path.size(); ++k)
    {
        cv::Matx33d positions[2];  // on the original and on the smooth path
        for (int smooth = 0; smooth < 2; ++smooth)
        {
            const int first = std::max(k - smooth * radius, 0),
                      last = std::min(k + smooth * radius, (int)path.size() - 1);
            cv::Vec4d mean;
            for (int i = first; i <= last; ++i)
                mean += path[i] * (1. / (last - first + 1));
            positions[smooth] = square(motion(cv::Point2d(middle[0], middle[1]),
                                              -mean[2] * 180 / CV_PI, std::exp(mean[3]),
                                              cv::Point2d(mean[0], mean[1])));
        }
        result.push_back(rows(positions[1].inv() * positions[0]));
    }
    return result;
}

//! Draws the mean of the original frames and the mean of the stabilized frames side by side; static
//! objects are sharp in the second mean. Writes the stabilized frames to `folder` unless it is
//! empty.
cv::Mat meanFrames(const std::vector<cv::Mat>& frames, const std::vector<cv::Matx23d>& moves,
                   const std::string& folder)
{
    const cv::Size size = frames[0].size();
    cv::Mat sums[2] = {cv::Mat(size, CV_32FC3, cv::Scalar::all(0)),
                       cv::Mat(size, CV_32FC3, cv::Scalar::all(0))};
    for (size_t k = 0; k < frames.size(); ++k)
    {
        cv::Mat moved;
        cv::warpAffine(frames[k], moved, moves[k], size, cv::INTER_LINEAR, cv::BORDER_REFLECT);
        cv::accumulate(frames[k], sums[0]);
        cv::accumulate(moved, sums[1]);
        const std::string file = folder + cv::format("/stable%04d.png", (int)k);
        if (!folder.empty() && !cv::imwrite(file, moved))
            CV_Error(cv::Error::StsError, file + ": cannot be written");
    }
    cv::Mat picture;
    cv::hconcat(sums[0], sums[1], picture);
    picture.convertTo(picture, CV_8U, 1. / frames.size());
    return picture;
}

int sample(const cv::CommandLineParser& parser)
{
    const std::string folder = parser.get<std::string>("@folder");
    const Sequence sequence = folder.empty()
                                  ? shaken(tools::readImage(parser.get<std::string>("image")), 30)
                                  : readFolder(folder);
    if (sequence.frames.size() < 2)
        CV_Error(cv::Error::StsError, folder + ": a folder with two images or more is expected");
    const tools::Settings settings(parser, 2000);
    std::vector<tools::Matches> matches;
    for (size_t k = 1; k < sequence.frames.size(); ++k)
        matches.push_back(tools::match(sequence.frames[k - 1], sequence.frames[k], parser));
    std::cout << sequence.frames.size() << " frames\n\n"
              << cv::format("%-10s %-18s %11s %6s %11s\n", "method", "mean, worst error",
                            "inliers %", "lost", "ms/frame");
    std::vector<cv::Matx23d> motions;
    double error = 0;
    estimate("RANSAC", cv::RANSAC, sequence, matches, settings, motions, error);
    estimate("LMEDS", cv::LMEDS, sequence, matches, settings, motions, error);
    const bool found = estimate("USACV20", (int)cv::USACV20, sequence, matches, settings, motions,
                                error);
    const cv::Mat picture = meanFrames(
        sequence.frames, corrections(motions, sequence.frames[0].size(), parser.get<int>("radius")),
        parser.get<std::string>("frames"));
    std::cout << std::endl;
    tools::writePicture(parser, picture, "mean of all frames: original (left), stabilized (right)");
    if (found && error < 1)
        return 0;
    std::cerr << "USACV20: " << (found ? "the error is too large" : "a motion has not been found")
              << std::endl;
    return 1;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string
        keys = "{help h usage ? |               | print this help}"
               "{@folder        |               | folder of images, the frames in the order of "
               "their names; none: frames are made from `image`}"
               "{image          | graf1.png     | image from which a sequence is made}"
               "{radius         | 15            | number of frames before and after a frame over "
               "which the path is averaged}"
               "{frames         |               | existing folder, to which the stabilized frames "
               "are written}"
               "{threshold      | 2             | inlier threshold in pixels}"
               "{ratio          | 0.8           | largest ratio of the descriptor distances of the "
               "best and the second best match}"
               "{features       | 1000          | largest number of features per frame}"
               "{confidence     | 0.99          | probability of finding the best model}"
               "{runs           | 3             | number of runs; the median time is printed}"
               "{width          | 1400          | largest width of the picture}"
               "{output o       | stabilize.jpg | picture to write}";
    return tools::runSample(argc, argv, keys, "Stabilizes a sequence of images.", sample);
}
