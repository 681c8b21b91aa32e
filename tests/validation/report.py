"""A page of tables with checks: what is asked, what was measured, whether it holds."""


def percent(value, digits=2):
    return f"{100 * value:.{digits}f} %"


class Report:
    def __init__(self):
        self.lines = []
        self.checks = []  # (section, what, held)
        self.section = ""

    def heading(self, title):
        self.section = title
        self.paragraph(f"## {title}")

    def paragraph(self, text):
        self.lines += [text, ""]

    def code(self, text):
        self.paragraph(f"```\n{text}\n```")

    def folded(self, title, text):
        self.paragraph(f"<details><summary>{title}</summary>\n\n```\n{text}\n```\n</details>")

    def table(self, header, rows):
        self.lines.append("| " + " | ".join(header) + " |")
        self.lines.append("|" + "---|" * len(header))
        self.lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
        self.lines.append("")

    def check(self, what, held, text):
        """The cell `text` with its mark."""
        self.checks.append((self.section, what, bool(held)))
        return f"{text} {'✓' if held else '**✗**'}"

    def at_most(self, what, value, limit, digits=2):
        """A share whose size is asked to be at most `limit`."""
        asked = f"{100 * limit:g} %"
        return self.check(what, abs(value) <= limit, f"{percent(value, digits)} (≤ {asked})")

    def at_least(self, what, value, limit, unit=""):
        return self.check(what, value >= limit, f"{value:.2f}{unit} (≥ {limit:g}{unit})")

    def verdict(self):
        failed = [f"{section}: {what}" for section, what, held in self.checks if not held]
        text = f"{len(self.checks) - len(failed)} of {len(self.checks)} checks hold."
        return text + "".join(f"\n- not met: {f}" for f in failed)

    def text(self):
        return "\n".join(self.lines).rstrip() + "\n"
