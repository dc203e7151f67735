"""Where C++ source can be changed by one token, and how. Imported by mutate."""

import re

# (pattern of a token, its replacements). Operators between expressions have spaces round them.
SWAPS = [
    (r" <= ", [" < "]), (r" >= ", [" > "]),
    (r" < (?![a-z])", [" <= "]), (r" < (?=[a-z])", [" <= "]), (r" > ", [" >= "]),
    (r" == ", [" != "]), (r" != ", [" == "]),
    (r" && ", [" || "]), (r" \|\| ", [" && "]),
    (r" \+ ", [" - "]), (r" - ", [" + "]), (r" \* ", [" / "]), (r" / ", [" * "]), (r" % ", [" / "]),
    (r" \+= ", [" -= ", " = "]), (r" -= ", [" += "]),
    (r"(?<=[(=,] )-(?=[\w(])", [""]), (r"(?<=\()-(?=[\w(])", [""]), (r"(?<=return )-(?=\w)", [""]),
    (r"std::min\(", ["std::max("]), (r"std::max\(", ["std::min("]),
    (r"\bmin_element", ["max_element"]), (r"\bmax_element", ["min_element"]),
    (r"cwiseMin", ["cwiseMax"]), (r"cwiseMax", ["cwiseMin"]),
    (r"\ball_of", ["any_of"]), (r"std::abs\(", ["("]), (r"\btrue\b", ["false"]),
    (r"\bfalse\b", ["true"]), (r"(?<=\()!(?=\w)", [""]), (r"(?<= )!(?=[\w(])", [""]),
    (r"\bstart\b(?=[;,)])", ["end"]), (r"\bkStart\b", ["kEnd"]), (r"\bkEnd\b", ["kInside"]),
    (r"if \((?=.*\) )", ["if (!"]),
]
NUMBER = re.compile(r"(?<![\w.\"])(\d+\.\d+|\d+)(?![\w.\">])")  # no template arguments
CALL = re.compile(r"^ +[\w.:\->\[\]()*]+ ?(=|\(|\+=|\*=|\+\+).*;$")


class Mutant:
    def __init__(self, path, line, begin, end, text, source_line):
        self.path, self.line, self.begin, self.end = path, line, begin, end
        self.text, self.before = text, source_line
        self.after = source_line[:begin] + text + source_line[end:]

    def applied_to(self, source):
        lines = source.split("\n")
        lines[self.line] = self.after
        return "\n".join(lines)

    def key(self):
        """Names the change also when lines above it come or go."""
        return "`{}` -> `{}`".format(self.before.strip(), self.after.strip())

    def __str__(self):
        return "{}:{}: {}".format(self.path, self.line + 1, self.key())


def other_numbers(text):
    value = float(text)
    others = [value + 1] if value in (0, 1) else [value / 2, value * 2]
    if value == 1:
        others.append(0)
    if "." not in text:
        return ["{:d}".format(int(other)) for other in others]
    return ["{:g}".format(other) for other in others]


def code_of(line):
    """Without comments; text in quotes blanked, since wording is not logic."""
    line = re.sub(r'"[^"]*"', lambda m: '"' + "\x00" * (len(m.group()) - 2) + '"', line)
    return line.split("//")[0]


def mutants_of_line(path, number, line):
    code = code_of(line)
    if not code.strip() or re.match(r"\s*(#|namespace|using|template|struct|case|assert)", code):
        return
    is_shift = "<<" in code
    for pattern, replacements in SWAPS:
        for found in re.finditer(pattern, code):
            if is_shift or "operator" in code:
                continue
            negates = found.group().startswith("if (")
            if negates and not whole_condition(code, found.end() - 1):
                continue
            for text in replacements:
                if negates:
                    close = whole_condition(code, found.end() - 1)
                    yield Mutant(path, number, found.end(), close,
                                 "!(" + line[found.end():close] + ")", line)
                else:
                    yield Mutant(path, number, found.start(), found.end(), text, line)
    for found in NUMBER.finditer(code):
        for text in other_numbers(found.group()):
            yield Mutant(path, number, found.start(), found.end(), text, line)
    if CALL.match(code) and not re.match(r" +(return|throw|const|double|Vec2|bool)\b", code):
        yield Mutant(path, number, len(line) - len(line.lstrip()), len(line), ";", line)


def whole_condition(code, opening):
    """Where the condition that begins with this parenthesis ends, if it does on this line."""
    depth = 0
    for i in range(opening, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            # `if (const auto x = ...)` declares: it cannot be negated.
            return None if re.search(r"(?<![=<>!])=(?!=)", code[opening:i]) else i
    return None


def mutants_of(path, source):
    """All of them, each once."""
    seen = set()
    for number, line in enumerate(source.split("\n")):
        for mutant in mutants_of_line(path, number, line):
            if mutant.after != mutant.before and (number, mutant.after) not in seen:
                seen.add((number, mutant.after))
                yield mutant
