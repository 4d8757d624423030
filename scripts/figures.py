#!/usr/bin/env python3
"""Prints how long files, classes and functions are, and fails where one is longer than it may be.

    figures.py                    prints the figures and checks them, after checking itself
    figures.py --update           lowers or drops the exceptions that are larger than needed; never adds or raises one

Limits: MOST_CLASS, MOST_FILE, MOST_FUNCTION, MOST_P95, MOST_MEMBERS and LEAST_TESTS below. Every source also needs a test file at the same place
below tests/. What is over a limit stands in figures_exceptions.txt with its figure of today. The list may only shrink:
an exception that is not needed, or larger than needed, is a fault as well.

A function is counted from its head to its closing brace, lambdas in it included; a class likewise, with the members
that are defined in it. Below SMALL_CLASSES the lines of members that are defined elsewhere count as well, and so do
the members themselves: data and methods, without types and without what is defaulted or deleted. The sources are clang-formatted and hold no tricks, so that matching braces is enough.
"""
import ast
import collections
import os
import re
import sys

MOST_CLASS = 300   # lines
MOST_FILE = 450    # lines
MOST_FUNCTION = 40  # lines
MOST_P95 = 30      # lines: 95 in 100 functions of a folder are no longer
MOST_MEMBERS = 20  # of a class: data and methods
LEAST_TESTS = 0.75  # lines of tests for a line of source

PROGRAM = ('common', 'worker', 'coordinator', 'client')
TOPS = PROGRAM + ('tests', 'scripts')
SMALL_CLASSES = ('coordinator',)
MIRRORED = ('common', 'worker', 'coordinator')
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
EXCEPTIONS = 'scripts/figures_exceptions.txt'

CLASS = re.compile(r'^(?:template\s*<.*>\s*)?(?:class|struct|union)\s+(?:alignas\([^)]*\)\s*)?(\w+)', re.DOTALL)
TRANSPARENT = re.compile(r'^(?:inline\s+)?namespace\b|^extern\s*$')
FUNCTION = re.compile(r'\)\s*(?:const\b|noexcept\b|override\b|final\b|try\b|&|\s)*(?:->[^;{}]*)?$', re.DOTALL)
NAME = re.compile(r'(?:TEST(?:_F|_P)?\((\w+, \w+)|((?:\w+::)*~?\w+))\s*[()]')


def bare(text):
    """C++ without comments, literals and directives; every character at its line."""
    out, i, n = [], 0, len(text)

    def skip(end):
        nonlocal i
        out.append(re.sub(r'[^\n]', ' ', text[i:end]))
        i = end

    while i < n:
        c = text[i]
        if text.startswith('//', i):
            skip(n if (end := text.find('\n', i)) < 0 else end)
        elif text.startswith('/*', i):
            skip(n if (end := text.find('*/', i)) < 0 else end + 2)
        elif c == '#' and text[:i].rpartition('\n')[2].strip() == '':
            end = i
            while (end := text.find('\n', end)) >= 0 and text[end - 1] == '\\':
                end += 1
            skip(n if end < 0 else end)
        elif raw := re.compile(r'R"([^()\\ ]*)\(').match(text, i):
            skip(text.index(f'){raw[1]}"', i) + len(raw[1]) + 2)
        elif c == '"' or (c == "'" and not (i and text[i - 1].isalnum())):
            skip(re.compile(r'(?:\\.|[^\\])*?' + c, re.DOTALL).match(text, i + 1).end())
        else:
            out.append(c)
            i += 1
    return ''.join(out)


Piece = collections.namedtuple('Piece', 'kind name line lines')  # kind: class or function


def pieces(text):
    """The classes and functions of a C++ source, those in functions left out."""
    code, found, stack, head, start = bare(text), [], [], '', 1
    line = 1
    for c in code:
        if c == '\n':
            line += 1
        inside = stack and stack[-1][0] not in ('open', 'class')
        if c == '{':
            stack.append((('block', '', 0, '') if inside else (*kind_of(head.strip()), start, head)))
            head = ''
        elif c == '}':
            kind, name, first, before = stack.pop()
            if kind in ('class', 'function'):
                found.append(Piece(kind, name, first, line - first + 1))
            # A list of values in braces is a part of what it stands in: of a function's head, of a declaration.
            head = before + '()' if kind == 'values' else ''
            start = first if kind == 'values' else line
        elif inside:
            continue
        elif c == ';' or (c == ':' and head.strip() in ('public', 'private', 'protected')):
            head = ''
        else:
            if not head.strip() and not c.isspace():
                start, head = line, ''
            head += c
    return found


NO_MEMBER = re.compile(r'(?:template\s*<.*>\s*)?(?:using|friend|typedef|static_assert|enum|class|struct|union)\b', re.DOTALL)


def statements(body):
    """What stands directly between the braces of a class, each declaration for itself; braces and what is in them as ()."""
    found, head, depth, opened = [], '', 0, ''
    for c in body:
        if c == '{':
            depth += 1
            if depth == 1:
                opened = kind_of(head.strip())[0]
        elif c == '}':
            depth -= 1
            if depth == 0:
                head += '()'
                if opened == 'function':
                    found, head = found + [head], ''
        elif depth:
            continue
        elif c == ';':
            found, head = found + [head], ''
        elif c == ':' and head.strip() in ('public', 'private', 'protected'):
            head = ''
        else:
            head += c
    return [text.strip() for text in found if text.strip()]


def members_of(body):
    """The number of data members and methods."""
    count = 0
    for text in statements(body):
        if NO_MEMBER.match(text) or re.search(r'=\s*(?:default|delete)$', text):
            continue
        text = re.sub(r'\)\s*:[^:].*', ')', text, flags=re.DOTALL)  # without what a constructor initializes
        while (less := re.sub(r'<[^<>]*>|\([^()]*\)', '', text)) != text:  # commas there separate no members
            text = less
        count += 1 + text.count(',')
    return count


def class_members(text):
    """(class, line, members) for every class of a C++ source."""
    code, found = bare(text), []
    for match in re.finditer(r'^[ \t]*(?:template\s*<[^;{]*>\s*)?(?:class|struct)\s+(\w+)[^;{}()]*\{', code, re.MULTILINE):
        depth, end = 1, match.end()
        while depth and end < len(code):
            depth += {'{': 1, '}': -1}.get(code[end], 0)
            end += 1
        found.append((match[1], code.count('\n', 0, match.start()) + 1, members_of(code[match.end():end - 1])))
    return found


def kind_of(head):
    """What a brace after `head` opens, and its name."""
    if TRANSPARENT.match(head):
        return 'open', ''
    if (match := CLASS.match(head)) and not FUNCTION.search(head):
        return 'class', match[1]
    if FUNCTION.search(head) and not re.match(r'(?:typedef\s+)?enum\b', head):
        name = NAME.search(head)
        return 'function', (name[1] or name[2]).replace(', ', '.') if name else 'operator'
    return 'values', ''


def python_pieces(text):
    nodes = [n for n in ast.walk(ast.parse(text)) if isinstance(n, (ast.FunctionDef, ast.ClassDef))]
    return [Piece('class' if isinstance(n, ast.ClassDef) else 'function', n.name, n.lineno, n.end_lineno - n.lineno + 1)
            for n in nodes]


def comment_lines(path, text):
    mark = '#' if path.endswith('.py') else '//'
    return sum(1 for line in text.splitlines() if line.strip().startswith(mark))


# members: (class, line, members) of a C++ source.
Source = collections.namedtuple('Source', 'path lines filled comments pieces members', defaults=((),))


def read(root):
    sources = []
    for top in TOPS:
        for folder, folders, names in os.walk(os.path.join(root, top)):
            folders.sort()
            for name in sorted(n for n in names if n.endswith(('.cc', '.h', '.py'))):
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(root, path), encoding='utf-8') as file:
                    text = file.read()
                lines = text.splitlines()
                sources.append(Source(path, len(lines), sum(1 for line in lines if line.strip()),
                                      comment_lines(path, text),
                                      python_pieces(text) if name.endswith('.py') else pieces(text),
                                      () if name.endswith('.py') else class_members(text)))
    return sources


def quantile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))] if values else 0


def in_top(sources, top):
    return [s for s in sources if top == 'all' or s.path.startswith(top + '/')]


def functions(sources):
    return [(p.lines, f'{s.path}:{p.line}') for s in sources for p in s.pieces if p.kind == 'function']


def test_of(path):
    return 'tests/' + path.removesuffix('.cc') + '_test.cc'


def test_share(sources):
    tests = sum(s.lines for s in in_top(sources, 'tests'))
    program = sum(s.lines for top in PROGRAM for s in in_top(sources, top) if not s.path.endswith('.py'))
    return tests / max(1, program)


def whole_classes(sources):
    """(lines, lines of the members defined outside, path, name) of every class."""
    outside = collections.Counter()  # by folder and class
    for s in sources:
        for p in s.pieces:
            if p.kind == 'function' and '::' in p.name:
                outside[os.path.dirname(s.path), p.name.split('::')[-2]] += p.lines
    return [(p.lines, outside[os.path.dirname(s.path), p.name], s.path, p.name)
            for s in sources for p in s.pieces if p.kind == 'class' and s.path.endswith(('.cc', '.h'))]


def over(sources):
    """What is over a limit: {(kind, name): figure}."""
    result = {}
    for s in sources:
        if s.lines > MOST_FILE:
            result['file', s.path] = s.lines
        for p in s.pieces:
            if p.lines > (MOST_CLASS if p.kind == 'class' else MOST_FUNCTION):
                result[p.kind, f'{s.path}:{p.name}'] = p.lines
    for top in TOPS + ('all',):
        p95 = quantile([lines for lines, _ in functions(in_top(sources, top))], 0.95)
        if p95 > MOST_P95:
            result['p95', top] = p95
    for top in SMALL_CLASSES:
        for s in in_top(sources, top):
            result.update({('members', f'{s.path}:{name}'): n for name, _, n in s.members if n > MOST_MEMBERS})
        for lines, more, path, name in whole_classes(in_top(sources, top)):
            if lines <= MOST_CLASS < lines + more:
                result['whole-class', f'{path}:{name}'] = lines + more
    paths = {s.path for s in sources}
    for top in MIRRORED:
        for s in in_top(sources, top):
            if s.path.endswith('.cc') and not s.path.endswith('/main.cc') and test_of(s.path) not in paths:
                result['untested', s.path] = 1
    if test_share(sources) < LEAST_TESTS:
        result['tests', 'all'] = int(100 * (LEAST_TESTS - test_share(sources))) + 1  # in hundredths
    return result


LIMITS = {'file': f'{MOST_FILE} lines', 'function': f'{MOST_FUNCTION} lines', 'class': f'{MOST_CLASS} lines', 'p95': f'{MOST_P95} lines for 95 in 100 functions',
          'members': f'{MOST_MEMBERS} members', 'whole-class': f'{MOST_CLASS} lines over all files',
          'untested': 'a test file at the same place below tests/',
          'tests': f'{LEAST_TESTS} lines of tests a line of source; hundredths that are missing'}


def check(found, excepted):
    """Faults, as lines."""
    faults = []
    for (kind, name), figure in sorted(found.items()):
        if (kind, name) not in excepted:
            faults.append(f'{name}: {kind} {figure}; the limit is {LIMITS[kind]}')
        elif figure > excepted[kind, name]:
            faults.append(f'{name}: {kind} {figure}; the exception allows {excepted[kind, name]}, the limit is {LIMITS[kind]}')
    for (kind, name), allowed in sorted(excepted.items()):
        figure = found.get((kind, name), 0)
        if figure < allowed:
            faults.append(f'{EXCEPTIONS}: {kind} {name} {allowed} is more than needed ({figure or "none"}): '
                          'scripts/figures.py --update')
    return faults


def read_exceptions(root):
    excepted = {}
    with open(os.path.join(root, EXCEPTIONS), encoding='utf-8') as file:
        for line in file:
            if line.strip() and not line.startswith('#'):
                kind, name, figure = line.split()
                excepted[kind, name] = int(figure)
    return excepted


def lowered(found, excepted):
    return {key: min(allowed, found[key]) for key, allowed in excepted.items() if key in found}


def write_exceptions(root, excepted):
    with open(os.path.join(root, EXCEPTIONS), 'w', encoding='utf-8') as file:
        file.write('# What is over a limit of scripts/figures.py, with its figure of today. This list may only shrink:\n'
                   '# scripts/figures.py --update lowers what became smaller and drops what is not needed.\n')
        for (kind, name), figure in sorted(excepted.items()):
            file.write(f'{kind} {name} {figure}\n')


def print_figures(sources):
    print(f'{"":12} {"files":>6} {"lines":>7} {"comments":>9} {"functions":>10} {"p50":>4} {"p95":>4}  longest function')
    for top in TOPS + ('all',):
        part = in_top(sources, top)
        found = sorted(functions(part))
        lengths = [lines for lines, _ in found]
        longest = f'{found[-1][0]:4} {found[-1][1]}' if found else ''
        filled = max(1, sum(s.filled for s in part))
        print(f'{top:12} {len(part):6} {sum(s.lines for s in part):7} {sum(s.comments for s in part) / filled:9.0%} '
              f'{len(found):10} {quantile(lengths, 0.5):4} {quantile(lengths, 0.95):4}  {longest}')
    print('\nlongest files')
    for s in sorted(sources, key=lambda s: -s.lines)[:8]:
        print(f'{s.lines:6}  {s.path}')
    print('\nlongest classes, and the lines of their members defined outside')
    for lines, more, path, name in sorted(whole_classes(sources), key=lambda c: -c[0] - c[1])[:8]:
        print(f'{lines:6} {more:6}  {path}:{name}')
    print('\nclasses of most members (data and methods)')
    for count, path, line, name in sorted(((n, s.path, line, name) for s in sources for name, line, n in s.members),
                                          key=lambda m: (-m[0], m[1:]))[:8]:
        print(f'{count:6}  {path}:{line}:{name}')
    print(f'\nlines of tests for a line of source: {test_share(sources):.2f}\n')


SAMPLE = r'''
#include <vector>
#define MACRO(x) \
  if (x) {
// A comment with { a brace.
namespace tilemend {
namespace {
constexpr char kText[] = "a } in a \" text", kBrace = '{';
constexpr int kMany[] = {1, 2, 1'000};
enum class Kind { kOne, kTwo };
struct Plain {
  Point3 p{0, 0, 0};
  int n() const { return 1; }
};
template <typename T>
class Long : public Base {
 public:
  explicit Long(int a) : a_(a), b_{a}, c_({}) {
    const auto f = [&](int x) {
      return x;
    };
  }
  int Get() const override {
    struct Inner {};
    return R"(})" != nullptr ? f({1}) : 0;
  }
  bool operator==(const Long&) const { return true; }

 private:
  int a_ = 0;
};
}  // namespace
Long::Long(int a) : Base{a} {}
auto Function(std::vector<int> many = {},
              int other = 2) -> std::pair<int, int> {
  if (other) {
    return {};
  }
  return {1, 2};
}
TEST_F(LongTest, HasAName) {}
}  // namespace tilemend
'''


MEMBERS = r'''
struct Many {
  using Lock = std::unique_lock<std::mutex>;
  enum class End { kOpen, kDone };
  struct Inside;
  Many(int a, int b) : a_(a), b_{b} {}
  Many(const Many&) = delete;
  friend bool Same(const Many&, const Many&);
  void Run(std::map<int, std::pair<int, int>> many = {}, int other = 2) const;
  template <class Make>
  auto Answer(Make make) { return make(); }
  std::function<void(int, int)> call = [](int, int) {};
  std::map<int, std::map<int, int>> a_, b_;
  std::array<int, 2> c_{1, 2}, d_ = {3, 4};
  const int e_ = 0;
};
'''


def check_itself():
    found = [(p.kind, p.name, p.line, p.lines) for p in pieces(SAMPLE)]
    wanted = [('function', 'n', 13, 1), ('class', 'Plain', 11, 4), ('function', 'Long', 18, 5), ('function', 'Get', 23, 4),
              ('function', 'operator', 27, 1), ('class', 'Long', 15, 17), ('function', 'Long::Long', 33, 1), ('function', 'Function', 34, 7),
              ('function', 'LongTest.HasAName', 41, 1)]
    faults = [] if found == wanted else [f'self-check: pieces {found}']
    if (text := bare('a = "{//"; // {\nb = \'{\';')) != 'a =      ;     \nb =    ;':
        faults.append(f'self-check: bare {text!r}')
    sources = [Source('common/a.cc', 500, 500, 0, [Piece('class', 'A', 1, 301), Piece('function', 'f', 1, 41)]),
               Source('worker/main.cc', 450, 450, 0, [Piece('class', 'B', 1, 300), Piece('function', '', 1, 30)]),
               Source('tests/common/b_test.cc', 800, 450, 0, [])]
    if (counted := class_members(SAMPLE + MEMBERS)) != [('Plain', 11, 2), ('Long', 15, 4), ('Inner', 24, 0), ('Many', 44, 9)]:
        faults.append(f'self-check: members {counted}')
    many = Source('coordinator/x.h', 9, 9, 0, [Piece('class', 'A', 1, 9), Piece('function', 'A::f', 9, 292)], [('A', 1, 21)])
    if {key: n for key, n in over([many]).items() if key[0] in ('members', 'whole-class')} != {
            ('members', 'coordinator/x.h:A'): 21, ('whole-class', 'coordinator/x.h:A'): 301}:
        faults.append('self-check: small classes')
    excess = over(sources)
    if excess != {('file', 'common/a.cc'): 500, ('class', 'common/a.cc:A'): 301, ('p95', 'common'): 41, ('p95', 'all'): 41,
                  ('function', 'common/a.cc:f'): 41, ('untested', 'common/a.cc'): 1, ('file', 'tests/common/b_test.cc'): 800}:
        faults.append(f'self-check: over {excess}')
    one = {('file', 'a'): 500}
    cases = [(one, one, 0), (one, {}, 1), (one, {('file', 'a'): 499}, 1), (one, {('file', 'a'): 501}, 1), ({}, one, 1)]
    for case, (now, excepted, count) in enumerate(cases):
        if len(check(now, excepted)) != count:
            faults.append(f'self-check: exceptions, case {case}')
    if lowered({('file', 'a'): 5, ('file', 'b'): 7}, {('file', 'a'): 6, ('file', 'b'): 6, ('file', 'c'): 6}) != {
            ('file', 'a'): 5, ('file', 'b'): 6}:
        faults.append('self-check: lowered')
    return faults


def main():
    sources = read(ROOT)
    found = over(sources)
    if '--update' in sys.argv:
        write_exceptions(ROOT, lowered(found, read_exceptions(ROOT)))
    print_figures(sources)
    faults = check_itself() + check(found, read_exceptions(ROOT))
    for line in faults:
        print(line)
    print(f'{len(sources)} files, {len(faults)} faults')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
