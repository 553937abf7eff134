"""The checks catch what they are for: each test writes a small tree with one fault and looks for the complaint."""
import os
import tempfile
import unittest

import check_equations
import check_includes
import check_sizes


class Tree:
    """A temporary tree from {path: text}."""

    def __init__(self, files):
        self.folder = tempfile.TemporaryDirectory()
        for path, text in files.items():
            full = os.path.join(self.folder.name, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)

    def complaints(self, check):
        with self.folder:
            return check(self.folder.name)


class Includes(unittest.TestCase):
    def check(self, files):
        return Tree(files).complaints(check_includes.check)

    def test_downward_is_fine(self):
        self.assertEqual([], self.check({"core/a.h": "#include <math.h>\n", "contact/law/b.c": '#include "core/a.h"\n',
                                         "include/hawser/hawser.h": "", "cli/main.c": "#include <hawser/hawser.h>\n",
                                         "linsolve/l.c": "#include <klu.h>\n", "sim/step/s.c": "#include <cvode/cvode.h>\n",
                                         "core/e.h": '#include "hawser/hawser.h"\n'}))

    def test_upward(self):
        found = self.check({"core/a.c": '#include "sim/run/sim.h"\n', "sim/run/sim.h": ""})
        self.assertEqual(1, len(found))
        self.assertIn("core/a.c:1", found[0])

    def test_upward_within_a_level(self):
        self.assertTrue(self.check({"theory/a.c": '#include "sim/run/sim.h"\n', "sim/run/sim.h": ""}))
        self.assertTrue(self.check({"sim/a.c": '#include "io/api/io.h"\n', "io/api/io.h": ""}))

    def test_sideways(self):
        self.assertTrue(self.check({"contact/law/a.c": '#include "linsolve/l.h"\n', "linsolve/l.h": ""}))
        self.assertTrue(self.check({"linsolve/a.c": '#include "contact/law/c.h"\n', "contact/law/c.h": ""}))

    def test_downward_within_a_folder(self):
        self.assertEqual([], self.check({"sim/a.c": '#include "sim/equipment/b.h"\n', "sim/equipment/b.h": "",
                                         "sim/run/c.c": '#include "sim/a.h"\n', "sim/a.h": '#include "sim/e.h"\n',
                                         "sim/e.h": "", "io/api/d.c": '#include "io/yaml/y.h"\n', "io/yaml/y.h": ""}))

    def test_upward_within_a_folder(self):
        found = self.check({"sim/equipment/b.c": '#include "sim/a.h"\n', "sim/a.h": '#include "sim/step/s.h"\n',
                            "sim/step/s.h": ""})
        self.assertEqual(["sim/a.h:1", "sim/equipment/b.c:1"], [c.split(": ")[0] for c in found])

    def test_sideways_within_a_folder(self):
        self.assertEqual(1, len(self.check({"contact/self/a.c": '#include "contact/surface/b.h"\n', "contact/surface/b.h": ""})))
        self.assertEqual(1, len(self.check({"contact/surface/a.c": '#include "contact/self/b.h"\n', "contact/self/b.h": ""})))

    def test_a_folder_that_is_not_in_the_list(self):
        found = self.check({"sim/odd/a.c": ""})
        self.assertEqual(["sim/odd/a.c: its folder is not in the list of docs/architecture.md"], found)

    def test_cli_sees_the_public_header_only(self):
        self.assertTrue(self.check({"cli/main.c": '#include "core/a.h"\n', "core/a.h": ""}))
        self.assertTrue(self.check({"cli/main.c": "#include <jansson.h>\n"}))

    def test_circle(self):
        found = self.check({"core/a.h": '#include "core/b.h"\n', "core/b.h": '#include "core/c.h"\n',
                            "core/c.h": '#include "core/a.h"\n'})
        self.assertEqual(["circle: core/a.h -> core/b.h -> core/c.h -> core/a.h"], found)

    def test_path_not_from_the_root(self):
        self.assertTrue(self.check({"core/a.c": '#include "b.h"\n', "core/b.h": ""}))

    def test_libraries_out_of_place(self):
        for path, name in [("core/a.c", "cvode/cvode.h"), ("linsolve/klu.c", "sundials/sundials_types.h"),
                           ("sim/a.c", "klu.h"), ("sim/a.c", "metis.h"), ("contact/law/a.c", "lapacke.h"),
                           ("sim/a.c", "yaml.h"), ("theory/a.c", "nvector/nvector_serial.h"),
                           ("sim/run/a.c", "cvode/cvode.h")]:
            self.assertEqual(1, len(self.check({path: f"#include <{name}>\n"})), (path, name))


class Equations(unittest.TestCase):
    MODEL = "# Bushing\n```\nd = x - y        (B1)\n```\nIt follows (B1) that\n- (C2) f = 0\n"

    def check(self, code, model=MODEL):
        return Tree({"docs/model.md": model, "core/a.c": code}).complaints(check_equations.check)

    def test_cited_and_given(self):
        self.assertEqual([], self.check('/* docs/model.md, "Bushing", (B1) and (C2) */ int f(void);\n'))

    def test_cited_but_not_given(self):
        self.assertEqual(["core/a.c:2: (B2) is not in docs/model.md"], self.check("\n/* by (B2) */\n"))

    def test_code_is_no_citation(self):
        self.assertEqual([], self.check("int x = (B2);\n"))

    def test_given_twice(self):
        self.assertTrue(self.check("", self.MODEL + "z = 1    (B1)\n"))

    def test_missing_section(self):
        self.assertTrue(self.check('/* docs/model.md, "Cable" */\n'))


class Sizes(unittest.TestCase):
    def check(self, text, path="core/a.c"):
        return Tree({path: text}).complaints(check_sizes.check)

    def test_long_function(self):
        def body(lines):
            return "static int f(int a)\n{\n" + "    a++;\n" * (lines - 2) + "}\n"
        self.assertEqual([], self.check(body(80)))
        self.assertEqual(1, len(self.check(body(81))))

    def test_long_files(self):
        self.assertEqual(1, len(self.check("int a;\n" * 601)))
        self.assertEqual(1, len(self.check("int a;\n" * 251, "core/a.h")))

    def test_full_folder(self):
        files = {f"core/a{k}.c": "" for k in range(check_sizes.FOLDER_MAX + 1)}
        self.assertEqual(1, len(Tree(files).complaints(check_sizes.check)))
        del files["core/a0.c"]
        self.assertEqual([], Tree({**files, "core/base/a0.c": ""}).complaints(check_sizes.check))

    def test_short_headers(self):
        files = {f"core/a{k}.h": "int a;\n" * 30 for k in range(3)}
        most, check_sizes.SHORT_HEADERS_MAX = check_sizes.SHORT_HEADERS_MAX, 2
        try:
            self.assertEqual(1, len(Tree(files).complaints(check_sizes.check)))
            files["core/a0.h"] += "int a;\n"
            self.assertEqual([], Tree(files).complaints(check_sizes.check))
        finally:
            check_sizes.SHORT_HEADERS_MAX = most

    def test_if_forest(self):
        self.assertEqual(1, len(self.check("#if A\n#endif\n" * 9)))


if __name__ == "__main__":
    unittest.main()
