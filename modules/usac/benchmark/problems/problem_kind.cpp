// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "problem_kind.hpp"

#include "two_view_files.hpp"

namespace benchmark {

namespace {

//! The objects of all problems in the order of cv::usacv20::ProblemType.
const std::vector<const ProblemKind*>& kinds()
{
    static const std::vector<const ProblemKind*> all = {
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) &kindOf##NAME(),
#include "../../src/problems/registry.inl.hpp"
    };
    return all;
}

std::string allLetters()
{
    std::string letters;
    for (const ProblemKind* kind : kinds())
        letters += kind->letter;
    return letters;
}

}  // namespace

ProblemKind::ProblemKind(ProblemType type_, char letter_, const cv::Size& modelSize_,
                         double threshold_, int maxIterations_)
    : type(type_), letter(letter_), modelSize(modelSize_), threshold(threshold_),
      maxIterations(maxIterations_)
{}

void ProblemKind::read(const std::string& path, ImagePair& pair) const
{
    readCorrespondences(path + ".corr", pair);
    const TruthReader in(path + ".json");
    readTwoViewTruth(in, letter, pair);
    checkTruth(in, pair);
    checkTruePoints(in, pair);
}

void ProblemKind::checkTruth(const TruthReader&, const ImagePair&) const {}

double ProblemKind::poseError(const ImagePair&, const Estimate&) const { return -1; }

double ProblemKind::centerError(const ImagePair&, const cv::Mat&) const { return -1; }

bool ProblemKind::failed(const ImagePair& pair, double error, double) const
{
    return !(error <= failureLimit(pair));
}

cv::Ptr<cv::usacv20::Usac> ProblemKind::estimator(const ImagePair& pair,
                                                  const cv::usacv20::Params& params) const
{
    return cv::usacv20::Usac::create(type, pair.points1, pair.points2, params);
}

const ProblemKind& kindOf(ProblemType problem) { return *kinds()[problem]; }

const std::string& problemLetters()
{
    static const std::string letters = allLetters();
    return letters;
}

char letterOf(ProblemType problem) { return kindOf(problem).letter; }

bool problemOf(char letter, ProblemType& problem)
{
    for (const ProblemKind* kind : kinds())
        if (kind->letter == letter)
        {
            problem = kind->type;
            return true;
        }
    return false;
}

}  // namespace benchmark
