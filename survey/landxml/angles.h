/* Angles of a LandXML file: the unit that it says, and which way around a curve's `delta` means. */
#ifndef HAWSER_SURVEY_LANDXML_ANGLES_H
#define HAWSER_SURVEY_LANDXML_ANGLES_H

typedef enum LandAngle { ANGLE_UNSAID, ANGLE_RADIANS, ANGLE_DEGREES, ANGLE_GRADS, ANGLE_SEXAGESIMAL } LandAngle;

/* By the word in angularUnit; NULL, or another word: not said. */
LandAngle land_angle_of(const char *name);

/* Whether an arc over a chord of that many diameters goes on beyond half a turn, by its angle delta, in the file's
 * unit, or, since files say none or get it wrong, in any that goes with the chord. -1: none does within a 200th of the
 * diameter. */
int land_long_way(double delta, LandAngle unit, double chord);

#endif
