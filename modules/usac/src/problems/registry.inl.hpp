// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// The table of problems, with a row for each kind of model. It is included several times;
// registry.hpp lists what is generated from it. Each file that includes it defines
//
//     USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS)
//
// and perhaps a macro USACV20_<ARGUMENTS> for each kind of arguments; all of these are undefined at
// the end of this file.
//
// TYPE       the enumerator of ProblemType for this kind of model
// NAME       estimate<NAME> is the public function, create<NAME>Problem() the factory
// PLURAL     estimate<PLURAL> is the public function for many sets of points
// ARGUMENTS  what the public functions take besides options; the factory takes only the cameras:
//            IMAGES   points1, points2: points of two images
//            SPACES   points1, points2: points of two spaces
//            CAMERAS  as IMAGES, and cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2
//            POSE     objectPoints, imagePoints, cameraMatrix, distCoeffs

USACV20_PROBLEM(HOMOGRAPHY, Homography, Homographies, IMAGES)
USACV20_PROBLEM(FUNDAMENTAL, Fundamental, Fundamentals, IMAGES)
USACV20_PROBLEM(ESSENTIAL, Essential, Essentials, CAMERAS)
USACV20_PROBLEM(AFFINITY, Affinity2D, Affinities2D, IMAGES)
USACV20_PROBLEM(SIMILARITY, Similarity2D, Similarities2D, IMAGES)
USACV20_PROBLEM(ABSOLUTE_POSE, AbsolutePose, AbsolutePoses, POSE)
USACV20_PROBLEM(RIGID_3D, Rigid3D, Rigids3D, SPACES)
USACV20_PROBLEM(SIMILARITY_3D, Similarity3D, Similarities3D, SPACES)
USACV20_PROBLEM(TRANSLATION_2D, Translation2D, Translations2D, IMAGES)

#undef USACV20_PROBLEM
#undef USACV20_IMAGES
#undef USACV20_SPACES
#undef USACV20_CAMERAS
#undef USACV20_POSE
