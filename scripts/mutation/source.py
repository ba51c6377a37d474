"""A C++ file as tokens, and the ends of expressions in it. Relies on the project's format: binary operators have spaces
on both sides, template brackets have none."""
import re
from dataclasses import dataclass

TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<directive>^[ \t]*#[^\n]*(?:\\\n[^\n]*)*)|(?P<string>"(?:\\.|[^"\\\n])*"|'
    r"'(?:\\.|[^'\\\n])+')|(?P<number>(?:0x[0-9a-fA-F.]+(?:p[+-]?\d+)?|\d[\d']*\.?\d*(?:[eE][+-]?\d+)?)\w*)|"
    r"(?P<name>[A-Za-z_]\w*)|(?P<mark>::|->|\+\+|--|<<=|>>=|[-+*/%<>=!&|^]=|&&|\|\||<<|[^\s\w])",
    re.MULTILINE | re.DOTALL)
OPEN, CLOSE = "([{", ")]}"
TIMES = ("*", "/", "%")


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    start: int
    end: int
    line: int


class Source:
    """The tokens of a text without its comments and directives."""

    def __init__(self, text):
        self.text = text
        self.tokens = []
        self.line_starts = [0] + [m.end() for m in re.finditer("\n", text)]
        line = 0
        for match in TOKEN.finditer(text):
            if match.lastgroup in ("comment", "directive"):
                continue
            while line + 1 < len(self.line_starts) and self.line_starts[line + 1] <= match.start():
                line += 1
            self.tokens.append(Token(match.lastgroup, match.group(), match.start(), match.end(), line + 1))

    def line_text(self, line):
        end = self.line_starts[line] if line < len(self.line_starts) else len(self.text)
        return self.text[self.line_starts[line - 1]:end].strip()

    def is_operand_end(self, k):
        """Whether an operand may end with token k."""
        return k >= 0 and (self.tokens[k].kind in ("name", "number") and self.tokens[k].text != "return"
                           or self.tokens[k].text in (")", "]"))

    def is_binary(self, k):
        """Whether token k is an operator between two operands."""
        t = self.tokens[k]
        return (self.is_operand_end(k - 1) and k + 1 < len(self.tokens) and self.text[t.start - 1].isspace()
                and self.text[t.end].isspace())

    def closing(self, k):
        """The bracket that closes the one at k."""
        depth = 0
        for j in range(k, len(self.tokens)):
            depth += (self.tokens[j].text in OPEN) - (self.tokens[j].text in CLOSE)
            if depth == 0:
                return j
        raise ValueError("unbalanced brackets")

    def opening(self, k):
        """The bracket around token k, or -1."""
        depth = 0
        for j in range(k - 1, -1, -1):
            depth += (self.tokens[j].text in CLOSE) - (self.tokens[j].text in OPEN)
            if depth < 0:
                return j
        return -1

    def unary_end(self, k):
        """The last token of the unary expression that begins at k; None where it is none that is understood."""
        tokens, last = self.tokens, None
        while k < len(tokens) and tokens[k].text in ("-", "!", "+"):
            k += 1
        while k < len(tokens):
            t = tokens[k]
            if t.text == "[" and last is None:
                return None  # a lambda
            if t.text in OPEN and (last is None or self.text[tokens[last].end:t.start] == ""):
                last = self.closing(k)
            elif t.text == "<" and last is not None and tokens[last].end == t.start:  # template arguments
                while tokens[k].text != ">":
                    k += 1
                last = k
            elif t.kind in ("name", "number") and (last is None or tokens[last].text in (".", "->", "::")):
                last = k
            elif t.text in (".", "->", "::") and last is not None:
                last = k
            else:
                break
            k = last + 1
        return last

    def term_end(self, k):
        """The last token of the product that begins at k."""
        end = self.unary_end(k)
        while end is not None and end + 1 < len(self.tokens) and self.tokens[end + 1].text in TIMES and self.is_binary(end + 1):
            end = self.unary_end(end + 2)
        return end

    def statement_end(self, k):
        """The last token before the ; or bracket that ends what begins at k."""
        while k < len(self.tokens) and self.tokens[k].text not in (";", ",", *CLOSE):
            k = self.closing(k) + 1 if self.tokens[k].text in OPEN else k + 1
        return k - 1

    def condition_start(self, k):
        """The first token of the condition before the ? at k."""
        j = k - 1
        while j >= 0 and self.tokens[j].text not in (";", ",", "=", "return", "else", ":", "?", "{", "}", "+=", "-=", *OPEN):
            if self.tokens[j].text in CLOSE:
                j = self.opening(j)
            j -= 1
        return j + 1
