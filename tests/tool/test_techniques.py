"""Options of `ups render` within a method, and the images of single techniques that it writes. Usage:
test_techniques.py PATH_TO_UPS [unittest options]"""
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "samples", "scenes_common"))
import need_numpy  # noqa: E402,F401
import numpy as np  # noqa: E402
import test_program  # noqa: E402
from exr import read_layers, read_rgb  # noqa: E402


class Techniques(test_program.ProgramTest):
    def test_images_add_up_to_the_picture(self):
        out = self.path("out")
        self.render("--method", "ups", "--iterations", 16, "--technique-images", 3, "--max-path-length", 3,
                    "--out", out)
        picture = read_rgb(os.path.join(out, "view.exr"))
        layers = read_layers(os.path.join(out, "view_techniques.exr"))
        self.assertGreater(picture.max(), 0)
        names = {f"connect_s{s}_t{k + 1 - s}" for k in (1, 2, 3) for s in range(k + 1)}
        names |= {f"merge_s{s}_t{k + 2 - s}" for k in (2, 3) for s in range(2, k + 1)}
        self.assertEqual(set(layers), {"path_integration", "density_estimation"}
                         | {f"{name}.{kind}" for name in names for kind in ("weighted", "unweighted")})
        weighted = sum(layer for name, layer in layers.items() if name.endswith(".weighted"))
        self.assertTrue(np.allclose(weighted, picture, rtol=1e-5))
        self.assertTrue(np.allclose(layers["path_integration"] + layers["density_estimation"], picture, rtol=1e-5))
        # A floor under a point light: next-event estimation is all that there is, so that its weight is 1.
        self.assertTrue(np.allclose(layers["connect_s1_t2.weighted"], layers["connect_s1_t2.unweighted"], rtol=1e-5))

    def test_none_without_asking(self):
        out = self.path("out")
        self.render("--iterations", 4, "--out", out)
        self.assertNotIn("view_techniques.exr", os.listdir(out))

    def test_a_mask_leaves_the_scene_to_be_the_next_word(self):
        result = self.render("--method", "bpt", "--iterations", 4, "--techniques", "light_sample,emitter_hit")
        self.assertEqual(result["techniques"], ["emitter_hit", "light_sample"])
        scene = self.write("room.gltf", test_program.room())
        self.run_program("render", "--techniques", "light_sample", scene, "--iterations", 4)

    def test_options_reach_the_method(self):
        def merges(*words):
            result = self.render("--method", "ppm", "--iterations", 32, "--light-paths", 4096, "--merge-radius", 0.2,
                                 *words)
            return result["work"]["merges"]

        slow, fast = merges("--alpha", 0.9), merges("--alpha", 0.3)
        self.assertGreater(slow, 1.3 * fast)
        self.assertGreater(merges(), fast)

        def mean_lx(*words):
            return self.render("--method", "pt", "--iterations", 64, "--merge-radius", 1,
                               *words)["meters"]["spot"]["mean_lx"]

        point, disc = mean_lx(), mean_lx("--perturbation", "actual")
        self.assertLess(disc, 0.97 * point)  # beneath the light, illuminance is greatest at the point

    def test_wrong_words_are_2_and_named(self):
        scene = self.write("room.gltf", test_program.room())
        for option, value in (("--alpha", "0"), ("--alpha", "1"), ("--alpha", "nan"), ("--alpha", "1e-50"),
                              ("--glossy-alpha", "0"), ("--glossy-alpha", "nan"), ("--merge-radius", "0"),
                              ("--techniques", "connekt"), ("--technique-images", "17"), ("--technique-images", "0"),
                              ("--perturbation", "real"), ("--light-paths", "0"), ("--max-path-length", "0")):
            with self.subTest(option=option, value=value):
                done = self.run_program("render", scene, "--iterations", 1, option, value, code=2)
                self.assertEqual(done.stdout, "")
                self.assertIn(option, done.stderr)

    def test_words_that_do_not_go_together_are_2_and_named(self):
        """As options, not as fields of the library's."""
        self.write("room.gltf", test_program.room())
        scene = test_program.room()
        scene["nodes"].append({"name": "far field", "extras": {"ups": {"goniometer": {}}}})
        scene["scenes"][0]["nodes"] = [0, 1, 5]
        self.write("far.gltf", scene)
        replay = ["replay", "room.gltf", "--sample", "spot/0/0/eye/0/1"]
        for arguments, words in (
                (["render", "room.gltf", "--method", "pt", "--perturbation", "actual"],
                 ["--perturbation: actual needs", "set --merge-radius, or"]),
                (["render", "room.gltf", "--method", "pt", "--techniques", "merge"],
                 ["--techniques: none of the method's", "; without it all are"]),
                (["render", "far.gltf", "--method", "pt", "--target-error", "0.02"],
                 ["--target-error: it would never be met", "set --method, --time or --iterations"]),
                ([*replay, "--method", "pt", "--techniques", "merge"], ["--techniques: none of the method's"])):
            with self.subTest(arguments=arguments):
                self.expect_failure(*arguments, words=words, code=2)
                self.assertNotRegex(self.run_program(*arguments, code=2).stderr, r"UPS_|[a-z]_(m|s|count|error)\b")


if __name__ == "__main__":
    test_program.PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
