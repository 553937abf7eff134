/* The scene that the tests of pushed cables share. */
#ifndef HAWSER_TESTS_PUSHED_FIXTURE_H
#define HAWSER_TESTS_PUSHED_FIXTURE_H

#include "tests/io/theory_fixture.h"

/* 22 kg/m in a straight duct with 30 mm of room, pushed at 22 m. */
static const char DUCT[] =
    "cables: {p: {d: 100 mm, mass: 22 kg/m, EI: 1000, EA: 60 MN, GA: 20 MN, GJ: 1000}}\n"
    "chain: [{cable: p, length: 400 m}]\n"
    "route: {head_at: 402 m, pieces: [{straight: 420 m}]}\nsurfaces: {ducts: [{radius: 80 mm}]}\n"
    "friction: {mu: 0.2}\ndrive: {winch: {speed: 0.2 m/s, to: 5 s, grip: axial}}\n"
    "conveyors: [{name: pusher, from: 20 m, to: 24 m, clamp: 40 kN, mu: 0.3, factor: 1.05, limit: 12 kN}]\n"
    "limits: {pull: 56 kN, sidewall: 3 kN/m, bend_radius: 2 m, push: 25 kN}\nrun: {duration: 60 s}\n";

#endif
