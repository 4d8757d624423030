#!/usr/bin/env python3
"""Counts the sentences of more than 25 words in the docs and in the comments of headers.

    sentences.py [--list N] [--most SHARE]

--list N      prints the N longest sentences with file and line
--most SHARE  fails if more than this share of the sentences, in percent, is too long

Tables, code, headings and link targets do not count. A sentence ends at . ? or ! before a space and a capital letter, at
the end of a paragraph or list item, and at a colon at the end of a line.
"""
import argparse
import re
import subprocess
import sys

MOST_WORDS = 25
END = re.compile(r'(?<=[.?!])["\')]*\s+(?=[A-Z`"(\[])')


def tracked(pattern):
    return subprocess.run(['git', 'ls-files', pattern], capture_output=True, text=True, check=True).stdout.split()


def paragraphs_of_markdown(lines):
    """(line number, text) of each paragraph and list item."""
    text, start, in_code = [], 0, False
    for number, line in enumerate(lines + [''], 1):
        line = line.rstrip()
        if line.lstrip().startswith('```'):
            in_code = not in_code
            line = ''
        skip = in_code or line.lstrip().startswith(('|', '#', '!', '<'))
        item = re.match(r'\s*([-*]|\d+\.)\s', line)
        if (not line or skip or item) and text:
            yield start, ' '.join(text)
            text = []
        if line and not skip:
            if not text:
                start = number
            text.append(line[item.end():] if item else line.strip())


def paragraphs_of_header(lines):
    """(line number, text) of each block of comments that has the form of sentences."""
    text, start = [], 0
    for number, line in enumerate(lines + [''], 1):
        comment = re.match(r'\s*// ?(.*)', line)
        body = comment.group(1) if comment else ''
        if (not body or body.startswith('  ')) and text:  # an indented line is a list or a formula
            yield start, ' '.join(text)
            text = []
        if body and not body.startswith('  '):
            if not text:
                start = number
            text.append(body)
            if body.endswith(':'):
                yield start, ' '.join(text)
                text = []


def sentences(text):
    text = re.sub(r'`[^`]*`', 'code', text)
    text = re.sub(r'\]\([^)]*\)', ']', text)
    return [s for s in END.split(text) if re.search(r'\w', s)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--list', type=int, default=0)
    parser.add_argument('--most', type=float)
    args = parser.parse_args()
    longest, all_long, count = [], 0, 0
    for group, files, paragraphs in (('docs', tracked('*.md'), paragraphs_of_markdown),
                                     ('headers', tracked('*.h'), paragraphs_of_header)):
        total = long = 0
        for path in files:
            for line, text in paragraphs(open(path, encoding='utf-8').read().split('\n')):
                for sentence in sentences(text):
                    words = len(sentence.split())
                    total += 1
                    if words > MOST_WORDS:
                        long += 1
                        longest.append((words, f'{path}:{line}', sentence))
        print(f'{group:8} {total:6} sentences, {long:5} of more than {MOST_WORDS} words ({100 * long / max(total, 1):.1f} %)')
        all_long, count = all_long + long, count + total
    for words, place, sentence in sorted(longest, reverse=True)[:args.list]:
        print(f'{words:4}  {place}: {sentence[:120]}')
    share = 100 * all_long / max(count, 1)
    print(f'all      {count:6} sentences, {all_long:5} too long ({share:.1f} %)')
    return args.most is not None and share > args.most


if __name__ == '__main__':
    sys.exit(main())
