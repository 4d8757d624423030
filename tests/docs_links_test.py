#!/usr/bin/env python3
"""Checks the relative links of every Markdown file: the file is there, and so is the heading that an #anchor names.

    docs_links_test.py ROOT

Anchors are those that GitHub makes of headings: lower case, spaces become hyphens, other punctuation goes, and a repeated
heading gets -1, -2 and so on. HTML anchors (id, name) count too. Links with a scheme (https:, mailto:) are not looked at.
Folders whose name begins with a dot and the build folder are left out. Checks itself first.
"""
import os
import re
import sys
import tempfile
import unicodedata
from urllib.parse import unquote

FENCE = re.compile(r'^ {0,3}(`{3,}|~{3,})[^\n]*\n.*?(?:^ {0,3}\1[`~]*[ \t]*$|\Z)', re.DOTALL | re.MULTILINE)
COMMENT = re.compile(r'<!--.*?-->', re.DOTALL)
CODE = re.compile(r'(?<!`)(`+)(?!`)((?:[^`]|`(?!\1))+?)(?<!`)\1(?!`)')
TARGET = r'(<[^<>\n]*>|(?:[^\s()]|\([^\s()]*\))*)(?:\s+(?:"[^"]*"|\'[^\']*\'|\([^()]*\)))?\s*'
INLINE = re.compile(r'\]\(\s*' + TARGET + r'\)')
DEFINITION = re.compile(r'^ {0,3}\[[^\]\n]+\]:[ \t]*(\S+)', re.MULTILINE)
HTML_LINK = re.compile(r'<(?:a|img)\b[^>]*?\b(?:href|src)\s*=\s*["\']([^"\']*)["\']', re.IGNORECASE)
HTML_ANCHOR = re.compile(r'<\w+\b[^>]*?\b(?:id|name)\s*=\s*["\']([^"\']+)["\']', re.IGNORECASE)
ATX = re.compile(r'^ {0,3}#{1,6}(?:[ \t]+(.*?))??(?:[ \t]+#+)?[ \t]*$', re.MULTILINE)
SETEXT = re.compile(r'^ {0,3}(?![-#>|])(\S[^\n]*)\n {0,3}(?:=+|-+)[ \t]*$', re.MULTILINE)
SCHEME = re.compile(r'^(?:[a-z][a-z0-9+.-]*:|//)', re.IGNORECASE)
LINES = re.compile(r'^L(\d+)(?:-L(\d+))?$')


def blank(match):
    """As many lines as what matched, with nothing on them."""
    return re.sub(r'[^\n]', ' ', match.group(0))


def without_blocks(text):
    return COMMENT.sub(blank, FENCE.sub(blank, text))


def links(text):
    """Line and target of every link that is not code."""
    text = CODE.sub(blank, without_blocks(text))
    found = [(match.start(), match.group(1)) for pattern in (INLINE, DEFINITION, HTML_LINK) for match in pattern.finditer(text)]
    return [(text.count('\n', 0, start) + 1, target.strip('<>')) for start, target in sorted(found)]


def slug(heading):
    """The anchor of a heading, before repeated ones are numbered."""
    text = re.sub(r'!\[[^\]]*\]\([^)]*\)', '', heading)
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text)
    text = re.sub(r'</?\w[^>]*>', '', text)
    text = re.sub(r'(?<!\w)_+(\S.*?)_+(?!\w)', r'\1', text)
    kept = (c for c in text.strip().lower() if c in ' -' or unicodedata.category(c)[0] in 'LM' or unicodedata.category(c) in ('Nd', 'Pc'))
    return ''.join(kept).replace(' ', '-')


def anchors(text):
    text = without_blocks(text)
    headings = sorted((match.start(), match.group(1) or '') for pattern in (ATX, SETEXT) for match in pattern.finditer(text))
    found, count = set(HTML_ANCHOR.findall(text)), {}
    for _, heading in headings:
        name = slug(heading)
        number = count.get(name, 0)
        count[name] = number + 1
        found.add(f'{name}-{number}' if number else name)
    return found


def read(path):
    with open(path, encoding='utf-8') as file:
        return file.read()


def markdown_files(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(f for f in folders if not f.startswith('.') and not (folder == root and f.startswith('build')))
        yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith('.md'))


def fault_of(root, page, target, known):
    """What is wrong with a link from the file `page`, or None. `known`: anchors by file, filled here."""
    path, _, anchor = target.partition('#')
    path, anchor = unquote(path.partition('?')[0]), unquote(anchor)
    full = page if not path else os.path.join(root, path.lstrip('/')) if path.startswith('/') else os.path.join(os.path.dirname(page), path)
    full = os.path.normpath(full)
    if os.path.commonpath([root, full]) != root:
        return 'leads out of the tree'
    if not os.path.exists(full):
        return 'no such file'
    if not anchor:
        return None
    if not full.endswith('.md'):
        line = LINES.match(anchor)
        inside = line and os.path.isfile(full) and int(line.group(2) or line.group(1)) <= len(read(full).splitlines())
        return None if inside else 'no such line'
    if full not in known:
        known[full] = anchors(read(full))
    return None if anchor in known[full] else 'no such heading'


def check(root):
    """Faults as lines, and how many links there are."""
    root, known, faults, count = os.path.abspath(root), {}, [], 0
    for page in markdown_files(root):
        for line, target in links(read(page)):
            if SCHEME.match(target):
                continue
            count += 1
            fault = fault_of(root, page, target, known)
            if fault:
                faults.append(f'{os.path.relpath(page, root)}:{line}: {target}: {fault}')
    return faults, count


PAGE = '''# One, *two* & `three_four`
[good](#one-two--three_four) [text
over lines](other.md#28-km) ![image](<there.png> "title") [a (b)](other.md#same-1)
`[code](not.md)` <!-- [comment](not.md) --> [away](https://example.org/not.md#not) [line](other.md?plain=1#same)

```sh
# no heading
[block](not.md)
```

Underlined
----------
[x]: other.md#same
<a id="html"></a> [html](#html) [under](#underlined) [root](/page.md)
[bad](not.md) [bad](#no-heading) [bad](other.md#same-2) [bad](../..)
'''
OTHER = '# 28 km²\n## Same ##\n## [Same](page.md)\n'


def check_itself():
    with tempfile.TemporaryDirectory(prefix='tilemend-links-') as root:
        for name, text in (('page.md', PAGE), ('other.md', OTHER), ('there.png', '')):
            with open(os.path.join(root, name), 'w', encoding='utf-8') as file:
                file.write(text)
        faults, count = check(root)
    wanted = [f'page.md:{PAGE.count(chr(10))}: {target}: {fault}' for target, fault in (
        ('not.md', 'no such file'), ('#no-heading', 'no such heading'), ('other.md#same-2', 'no such heading'), ('../..', 'leads out of the tree'))]
    return [] if (faults, count) == (wanted, 14) else [f'self-check: {count} links, {faults}']


def main():
    faults, count = check(sys.argv[1])
    faults = check_itself() + faults + ([] if count >= 50 else [f'only {count} links were found'])
    print('\n'.join(faults) or f'{count} relative links, all lead somewhere')
    return bool(faults)


if __name__ == '__main__':
    sys.exit(main())
