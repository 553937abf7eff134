/* YAML into a tree: lines, keys, settings; and files that are not what they should be. */
#include "tests/io/case_fixture.h"

#include <sys/stat.h>
#include <unistd.h>

#include "io/case/yaml.h"

static CaseTree *tree_of(const char *text)
{
    CaseTree *tree;
    hawser_error err;
    if (case_tree_parse(text, NAME, &tree, &err)) fail_msg("refused: %s", err.message);
    return tree;
}

/* The text must be refused with a message that begins with `begin` and holds `part`. */
static void refused(const char *text, const char *begin, const char *part)
{
    CaseTree *tree;
    hawser_error err = {0};
    assert_int_equal(case_tree_parse(text, NAME, &tree, &err), HAWSER_ERR_INPUT);
    assert_null(tree);
    if (strncmp(err.message, begin, strlen(begin)) != 0) fail_msg("'%s' does not begin: %s", begin, err.message);
    if (!strstr(err.message, part)) fail_msg("'%s' is not in: %s", part, err.message);
}

TEST(nodes_know_their_places)
{
    CaseTree *tree = tree_of("# first\na: 1\nb:\n  c: [x,\n      {y: 'z w'}]\n");
    const CaseNode *b = case_node_key(tree->root, "b"), *c = case_node_key(b, "c");
    const CaseNode *y = case_node_key(case_node_item(c, 1), "y");
    char path[CASE_PATH_MAX];
    assert_int_equal(case_node_key(tree->root, "a")->line, 2);
    assert_int_equal(b->line, 3);
    assert_int_equal(c->line, 4);
    assert_int_equal(y->line, 5);
    assert_string_equal(y->text, "z w");
    assert_string_equal(y->origin, NAME);
    assert_string_equal(case_path(y, NULL, path), "b.c.1.y");
    assert_string_equal(case_path(c, "d", path), "b.c.d");
    assert_int_equal(c->count, 2);
    assert_null(case_node_item(c, 2));
    assert_null(case_node_item(b, 0));
    assert_null(case_node_key(c, "y"));
    assert_null(case_node_key(NULL, "y"));
    case_tree_free(tree);
}

TEST(aliases_are_written_out)
{
    CaseTree *tree = tree_of("a: &p {k: 1}\nb: [*p, *p]\n");
    const CaseNode *b = case_node_key(tree->root, "b");
    for (int i = 0; i < 2; i++) assert_string_equal(case_node_key(case_node_item(b, i), "k")->text, "1");
    case_tree_free(tree);
}

TEST(not_a_case)
{
    refused("", NAME ":1:", "nothing is in it");
    refused("# only a comment\n", NAME ":1:", "nothing is in it");
    refused("just words\n", NAME ":1:", "a case is a map");
    refused("- a\n- b\n", NAME ":1:", "a case is a map");
    refused("a: 1\n---\nb: 2\n", NAME ":2:", "second document");
    refused("a: 1\nb: 2\na: 3\n", NAME ":3:", "stands here twice: 'a'");
    refused("a: {k: 1, k: 2}\n", NAME ":1:", "twice: 'k'");
    refused("a:\n\tb: 1\n", NAME ":2:", "tab");
    refused("a: [1, 2\nb: 3\n", NAME, "not YAML");
    refused("a: 'open\n", NAME, "not YAML");
    refused("a: b: c\n", NAME ":1:", "not YAML");
    refused("a: *nobody\n", NAME ":1:", "not YAML");
    refused("? [x, y]\n: 1\n", NAME ":1:", "a key must be a plain word");
    refused("\"\": 1\n", NAME ":1:", "a key is empty");
    refused("a: 1\nb: \"x\\0y\"\n", NAME ":2:", "NUL");
    refused("a: &x [*x]\n", NAME ":1:", "alias inside itself");
    refused("a: 1\nb: \x01\n", NAME ":2:", "not YAML");
    refused("a: 1\nb: 2\nc: \xff\xfe\n", NAME ":3:", "not YAML");
}

/* At the beginning it is no part of the text. */
TEST(byte_order_mark)
{
    CaseTree *tree = tree_of("\xef\xbb\xbf"
                             "a: 1\nb: 2\n");
    assert_string_equal(case_node_key(tree->root, "a")->text, "1");
    assert_int_equal(case_node_key(tree->root, "a")->line, 1);
    assert_int_equal(case_node_key(tree->root, "b")->line, 2);
    case_tree_free(tree);
    refused("\xef\xbb\xbf", NAME ":1:", "nothing is in it");
    refused("\xef\xbb\xbf"
            "a: 1\n\tb: 2\n",
            NAME ":2:", "tab");
}

/* Nine aliases to the power of nine. */
TEST(alias_bomb)
{
    char text[4096] = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
    for (int k = 1; k < 10; k++) {
        char line[200];
        const int b = k - 1;
        snprintf(line, sizeof line, "a%d: &a%d [*a%d, *a%d, *a%d, *a%d, *a%d, *a%d, *a%d, *a%d, *a%d]\n", k, k, b, b, b,
                 b, b, b, b, b, b);
        strcat(text, line);
    }
    refused(text, NAME, "too many values");
}

/* n times `open`, as one value. */
static void nested(int n, const char *open)
{
    const size_t width = strlen(open);
    char *text = malloc((size_t)n * width + 16);
    assert_non_null(text);
    strcpy(text, "a: ");
    for (int k = 0; k < n; k++) memcpy(text + 3 + (size_t)k * width, open, width + 1);
    refused(text, NAME, "");
    free(text);
}

TEST(deep_nesting)
{
    refused("a: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[x]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n", NAME ":1:", "nested too deeply");
    nested(100000, "[");
    nested(100000, "{a: ");
    nested(100000, "- ");
    nested(20000, "? ");
}

/* `line` with its number in place of %d, n times, behind `begin`. */
static char *lines_of(int n, const char *begin, const char *line)
{
    char *text = malloc((size_t)n * 40 + 40);
    assert_non_null(text);
    size_t used = (size_t)sprintf(text, "%s", begin);
    for (int k = 0; k < n; k++) {
        const char *number = strstr(line, "%d");
        used += (size_t)sprintf(text + used, "%.*s%d%s", (int)(number - line), line, k, number + 2);
    }
    return text;
}

TEST(many_of_a_kind)
{
    static const struct {
        int n;
        const char *begin, *line, *place, *part;
    } cases[] = {{600, "", "k%d: 1\n", NAME ":501:", "too many keys"},
                 {100000, "a:\n", "  - &x%d 1\n", NAME ":1002:", "too many anchors"},
                 {100000, "", "%TAG !x%d! tag:x\n", NAME, "too many tags"},
                 {600000, "a:\n", "  - %d\n", NAME ":", "too many values"}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char *text = lines_of(cases[k].n, cases[k].begin, cases[k].line);
        refused(text, cases[k].place, cases[k].part);
        free(text);
    }
}

/* Junk of all kinds is refused or read, never more: 3000 texts of bytes that YAML likes, seed fixed. */
TEST(random_junk)
{
    static const char likes[] = "a:b- \n\t[]{},&*!|>'\"%@`#?~0\x80\xc3\xa9\x01\\";
    unsigned seed = 12345;
    for (int round = 0; round < 3000; round++) {
        char text[64];
        hawser_error err;
        CaseTree *tree;
        SceneDef def;
        for (size_t k = 0; k < sizeof text - 1; k++) {
            seed = seed * 1103515245u + 12345u;
            text[k] = likes[(seed >> 16) % (sizeof likes - 1)];
        }
        text[sizeof text - 1] = 0;
        hawser_status status = case_tree_parse(text, NAME, &tree, &err);
        if (!status) status = case_read(tree, &def, &err);
        assert_int_equal(status, HAWSER_ERR_INPUT);
        case_tree_free(tree);
    }
}

TEST(files)
{
    static const struct {
        const char *path, *part;
    } cases[] = {{"/nowhere/at/all.yaml", "/nowhere/at/all.yaml: cannot be opened: No such file"},
                 {"/tmp", "/tmp: cannot be read: Is a directory"},
                 {"/dev/zero", "/dev/zero: cannot be read: not a file"},
                 {"/dev/null", "/dev/null: cannot be read: not a file"}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        CaseTree *tree;
        hawser_error err;
        assert_int_equal(case_tree_load(cases[k].path, &tree, &err), HAWSER_ERR_INPUT);
        assert_null(tree);
        if (strncmp(err.message, cases[k].part, strlen(cases[k].part)) != 0) fail_msg("%s", err.message);
    }
}

/* A file that may not be read; root may read everything. */
TEST(forbidden_file)
{
    char path[] = "/tmp/hawser_case_XXXXXX";
    const int fd = mkstemp(path);
    CaseTree *tree;
    hawser_error err;
    check_at_least(fd, 0);
    assert_int_equal(write(fd, "a: 1\n", 5), 5);
    close(fd);
    assert_int_equal(case_tree_load(path, &tree, &err), HAWSER_OK);
    case_tree_free(tree);
    chmod(path, 0);
    const hawser_status status = case_tree_load(path, &tree, &err);
    unlink(path);
    if (geteuid() != 0) assert_int_equal(status, HAWSER_ERR_INPUT);
    case_tree_free(tree);
}

static const char *text_at(const CaseTree *tree, const char *a, int item, const char *b)
{
    const CaseNode *node = case_node_key(case_node_item(case_node_key(tree->root, a), item), b);
    assert_non_null(node);
    return node->text;
}

TEST(settings)
{
    hawser_error err;
    CaseTree *tree = tree_of("chain:\n  - {length: 1 m, x: 1}\n  - {length: 2 m}\nlast: 1\n");
    assert_int_equal(case_tree_set(tree, "chain.1.length", "250 mm", &err), HAWSER_OK);
    assert_string_equal(text_at(tree, "chain", 1, "length"), "250 mm");
    assert_string_equal(text_at(tree, "chain", 0, "length"), "1 m");
    assert_int_equal(case_tree_set(tree, "chain.0.new", "-5 deg", &err), HAWSER_OK);
    assert_string_equal(text_at(tree, "chain", 0, "new"), "-5 deg");
    assert_int_equal(case_tree_set(tree, "a.b.c", "[0, 0, -9.8]", &err), HAWSER_OK);
    const CaseNode *c = case_node_key(case_node_key(case_node_key(tree->root, "a"), "b"), "c");
    assert_int_equal(c->count, 3);
    assert_int_equal(c->line, 0);
    assert_string_equal(c->origin, "--set a.b.c");
    assert_int_equal(case_tree_set(tree, "last", "2", &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "last", "3", &err), HAWSER_OK);
    assert_string_equal(case_node_key(tree->root, "last")->text, "3");
    assert_int_equal(case_tree_set(tree, "chain", "[]", &err), HAWSER_OK);
    assert_int_equal(case_node_key(tree->root, "chain")->count, 0);
    assert_int_equal(case_tree_set(tree, "empty", "", &err), HAWSER_OK);
    assert_string_equal(case_node_key(tree->root, "empty")->text, "");
    case_tree_free(tree);
}

TEST(bad_settings)
{
    char longest[400];
    memset(longest, 'k', sizeof longest - 1);
    longest[sizeof longest - 1] = 0;
    const struct {
        const char *key, *value, *part;
    } cases[] = {{"chain.2.length", "1 m", "--set chain.2.length: no item '2': the list has 2"},
                 {"chain.-1.length", "1 m", "no item '-1'"},
                 {"chain.99999999999999999999.length", "1 m", "no item"},
                 {"chain.0x1.length", "1 m", "no item"},
                 {"chain.first", "1 m", "no item 'first'"},
                 {"chain.0.length.more", "1 m", "a value, not a map, comes before 'more'"},
                 {"", "1", "a part of the key is empty"},
                 {"a..b", "1", "a part of the key is empty"},
                 {"a.", "1", "a part of the key is empty"},
                 {"a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q", "1", "too many parts"},
                 {longest, "1", "too long"},
                 {"a", "[1, 2", "--set a: not YAML"},
                 {"a", "{x: 1, x: 2}", "--set a: this key stands here twice"},
                 {"a", "1\n---\n2", "second document"},
                 {"a", "# nothing", "--set a: nothing is in it"}};
    CaseTree *tree = tree_of("chain:\n  - {length: 1 m}\n  - {length: 2 m}\n");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        hawser_error err = {0};
        assert_int_equal(case_tree_set(tree, cases[k].key, cases[k].value, &err), HAWSER_ERR_INPUT);
        if (!strstr(err.message, cases[k].part)) fail_msg("'%s' is not in: %s", cases[k].part, err.message);
        assert_int_equal(tree->root->count, 1);
        assert_int_equal(tree->root->first->count, 2);
    }
    case_tree_free(tree);
}

/* Messages stay on one line and within their size, whatever the user wrote. */
TEST(shown_texts)
{
    char shown[CASE_SHOWN_MAX], longest[400], place[CASE_PLACE_MAX];
    assert_string_equal(case_shown("a\nb\tc", shown), "'a b c'");
    memset(longest, 'k', sizeof longest - 1);
    longest[sizeof longest - 1] = 0;
    check_below(strlen(case_shown(longest, shown)), CASE_SHOWN_MAX);
    check_has(shown, "...");
    for (int k = 0; k < 398; k += 2) memcpy(longest + k, "\xc3\xa9", 2);
    for (int shift = 0; shift < 2; shift++) {
        case_shown(longest + 2 * shift, shown);
        assert_int_equal((strlen(shown) - 5) % 2, 0);
    }
    check_below(strlen(case_place(longest, 7, place)), CASE_PLACE_MAX);
    assert_string_equal(case_place("f.yaml", 7, place), "f.yaml:7");
    assert_string_equal(case_place("--set a", 0, place), "--set a");
}

TEST(near_words)
{
    static const char *const names[] = {"length", "segment", "swivel", "E", "EI"};
    assert_string_equal(hawser_nearest("lenght", names, 5), "length");
    assert_string_equal(hawser_nearest("Length", names, 5), "length");
    assert_string_equal(hawser_nearest("segmnt", names, 5), "segment");
    assert_string_equal(hawser_nearest("segments", names, 5), "segment");
    assert_string_equal(hawser_nearest("ei", names, 5), "EI");
    assert_null(hawser_nearest("zebra", names, 5));
    assert_null(hawser_nearest("averyveryveryveryverylongwordindeed", names, 5));
}

/* A number that is another item's name is refused; as the name of the item that has it, or beyond the list, it is
 * clear. */
TEST(names_that_are_numbers)
{
    CaseTree *tree;
    hawser_error err;
    const char *const text = "pieces: [{name: 1, straight: 1 m}, {name: B, straight: 2 m}, {name: 2}, {name: 7}]";
    assert_int_equal(case_tree_parse(text, "numbers", &tree, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "pieces.1.straight", "5 m", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "1 is the number of the item 'B' and the name of the item with the number 0");
    assert_int_equal(case_tree_set(tree, "pieces.0.straight", "5 m", &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "pieces.2.straight", "6 m", &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "pieces.7.straight", "7 m", &err), HAWSER_OK);
    const CaseNode *const pieces = case_node_key(tree->root, "pieces");
    assert_string_equal(case_node_key(case_node_item(pieces, 0), "straight")->text, "5 m");
    assert_string_equal(case_node_key(case_node_item(pieces, 3), "straight")->text, "7 m");
    case_tree_free(tree);
}

/* What turns or hides text is no more welcome in a name than what commands a terminal. */
TEST(texts_that_turn)
{
    static const char *const marks[] = {"\xe2\x80\xae", "\xe2\x80\x8f", "\xe2\x81\xa6", "\xef\xbb\xbf", "\xd8\x9c"};
    for (size_t k = 0; k < sizeof marks / sizeof *marks; ++k) {
        char text[64];
        CaseTree *tree;
        hawser_error err;
        snprintf(text, sizeof text, "title: a%sb", marks[k]);
        assert_int_equal(case_tree_parse(text, "turned", &tree, &err), HAWSER_ERR_INPUT);
        check_has(err.message, "turned:1");
        snprintf(text, sizeof text, "a%sb: 1", marks[k]);
        assert_int_equal(case_tree_parse(text, "turned", &tree, &err), HAWSER_ERR_INPUT);
    }
}

/* Items of a list go by their name too, if one alone has it. */
TEST(items_by_name)
{
    CaseTree *tree;
    hawser_error err;
    const char *const text =
        "pieces: [{name: A, straight: 1 m}, {name: B-C, straight: 2 m}, {name: twin}, {name: twin}]";
    assert_int_equal(case_tree_parse(text, "named", &tree, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "pieces.B-C.straight", "5 m", &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "pieces.0.straight", "6 m", &err), HAWSER_OK);
    CaseTree *const copy = case_tree_copy(tree);
    assert_non_null(copy);
    assert_int_equal(case_tree_set(copy, "pieces.A.straight", "7 m", &err), HAWSER_OK);
    const CaseNode *const pieces = case_node_key(tree->root, "pieces");
    assert_string_equal(case_node_key(case_node_item(pieces, 1), "straight")->text, "5 m");
    assert_string_equal(case_node_key(case_node_item(pieces, 0), "straight")->text, "6 m");
    const CaseNode *const copied = case_node_key(copy->root, "pieces");
    assert_string_equal(case_node_key(case_node_item(copied, 0), "straight")->text, "7 m");
    assert_int_equal(case_tree_set(tree, "pieces.twin.straight", "1 m", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "2 items have the name 'twin': give the number, from 0");
    assert_int_equal(case_tree_set(tree, "pieces.D.straight", "1 m", &err), HAWSER_ERR_INPUT);
    check_has(err.message, "no item 'D'");
    case_tree_free(copy);
    case_tree_free(tree);
}
