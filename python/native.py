"""Makes hawser._native: the C interface for Python, by cffi in API mode. setup.py runs it; `link` says where libhawser is."""
from __future__ import annotations

import json
import pathlib
import subprocess
from typing import Any

import cffi
import declarations

HERE = pathlib.Path(__file__).resolve().parent

# What C does for Python besides: call-backs, and a step of work that ends soon, so that Ctrl-C is noticed.
OWN_DECLARATIONS = """
extern "Python" int hawser_python_progress(void *user, const hawser_sample *sample, double wall_s, double end_s);
extern "Python" int hawser_python_certify(void *user, const hawser_certify_state *state);
extern "Python" int hawser_python_on_step(void *user, hawser_sim *s, double t);
extern "Python" int hawser_python_on_event(void *user, hawser_sim *s, const hawser_event *event);
extern "Python" void hawser_python_on_log(void *user, hawser_log_level level, const char *text);
extern "Python" int hawser_python_law(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36],
                                      double by_motion[36]);
extern "Python" int hawser_python_study(void *user, const hawser_study_state *state);
hawser_status hawser_python_advance(hawser_sim *s, double t, double wall_s, hawser_error *err);
"""
OWN_SOURCE = """
#include <hawser/hawser.h>
#include <time.h>

static double hawser_python_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Advances toward t (s) by the integrator's own steps until it is there or wall_s (s) have gone by: at least one step. The
 * steps are those of a single call. */
static hawser_status hawser_python_advance(hawser_sim *s, double t, double wall_s, hawser_error *err)
{
    const double end = hawser_python_clock() + wall_s;
    hawser_status status = HAWSER_OK;
    do {
        status = hawser_sim_advance(s, t, 1, err);
    } while (!status && hawser_sim_time(s) < t && hawser_python_clock() < end);
    return status;
}
"""


def pkg_config(*wanted: str) -> list[str]:
    return subprocess.run(["pkg-config", *wanted, "hawser"], check=True, capture_output=True, text=True).stdout.split()


def link() -> dict[str, Any]:
    """Version, folder of the headers, and what to link: as hawser's own build has written it beside this file, or of an
    installed hawser."""
    written = HERE / "native.json"
    if written.exists():
        found: dict[str, Any] = json.loads(written.read_text(encoding="utf-8"))
        return found
    return {"version": pkg_config("--modversion")[0], "include": pkg_config("--variable=includedir")[0],
            "objects": [], "link": pkg_config("--libs")}


def builder() -> cffi.FFI:
    how = link()
    include = pathlib.Path(how["include"])
    ffi = cffi.FFI()
    ffi.cdef(declarations.declarations(include) + OWN_DECLARATIONS)
    # extra_objects stand before the libraries that they need
    ffi.set_source("hawser._native", OWN_SOURCE, include_dirs=[str(include)], extra_objects=how["objects"],
                   extra_link_args=how["link"], depends=how["objects"],
                   extra_compile_args=["-std=gnu17", *(["-g0"] if how["objects"] else [])])  # a package system keeps symbols apart
    return ffi


def write_declared(path: pathlib.Path) -> None:
    """The module hawser._declared: what the headers said when the extension was made."""
    include = pathlib.Path(link()["include"])
    path.write_text('"""Written by native.py from the public headers."""\n'
                    f"VERSION: str = {link()['version']!r}\n"
                    f"DIGEST: str = {declarations.digest(include)!r}\n"
                    f"FUNCTIONS: list[str] = {declarations.functions(declarations.declarations(include))!r}\n"
                    f"MEMBERS: dict[str, dict[str, str]] = {json.dumps(declarations.members(include), indent=1)}\n",
                    encoding="utf-8")
