"""Pictures of jobs and targets of a robot for which nobody has drawn any, some made of pictures of it (§5.6.2)."""

from collections.abc import Sequence

from onika.model.picture import BLACK, SIZE, Picture, framed

_WHITE, _GREY, _RED = "7", "6", "0"

_TURNED = (
    "  ####    ",
    " ##  ##   ",
    " #    ##  ",
    "      ##  ",
    "    ######",
    "     #### ",
    "      ##  ",
)
_STRAIGHT = (
    "        #   ",
    "        ##  ",
    "########### ",
    "############",
    "########### ",
    "        ##  ",
    "        #   ",
)

_HAND = (
    "            ######            ",
    "            ######            ",
    "            ######            ",
    "       ################       ",
    "       ################       ",
    "       ################       ",
    "       ###          ###       ",
    "       ###          ###       ",
    "       ###          ###       ",
    "       ###  ......  ###       ",
    "   -   ###  ......  ###   -   ",
    "  --   ###  ......  ###   --  ",
    " ----- ###  ......  ### ----- ",
    "  --   ###  ......  ###   --  ",
    "   -   ###  ......  ###   -   ",
    "       ###          ###       ",
    "       ###          ###       ",
)
_CAR = (
    "                      -       ",
    "                      --      ",
    "               ------------   ",
    "               ------------   ",
    "                      --      ",
    "                      -       ",
    "                              ",
    "      ..................      ",
    "      ..................      ",
    "      ..................      ",
    "      ..................      ",
    "      ..................      ",
    "        ####      ####        ",
    "       ######    ######       ",
    "       ######    ######       ",
    "        ####      ####        ",
)
_OPENED = (
    "            ######            ",
    "            ######            ",
    "            ######            ",
    " ############################ ",
    " ############################ ",
    " ############################ ",
    " ###                      ### ",
    " ###                      ### ",
    " ###                      ### ",
    " ###     -          -     ### ",
    " ###    --          --    ### ",
    " ###   ------    ------   ### ",
    " ###    --          --    ### ",
    " ###     -          -     ### ",
    " ###                      ### ",
    " ###                      ### ",
    " ###                      ### ",
)
_CLOSED = (
    "            ######            ",
    "            ######            ",
    "            ######            ",
    " ############################ ",
    " ############################ ",
    " ############################ ",
    "            ### ###           ",
    "            ### ###           ",
    "            ### ###           ",
    "       -    ### ###    -      ",
    "       --   ### ###   --      ",
    "   ------   ### ###   ------  ",
    "       --   ### ###   --      ",
    "       -    ### ###    -      ",
    "            ### ###           ",
    "            ### ###           ",
    "            ### ###           ",
)
_GOAL = (
    "                      ######  ",
    "                     ##    ## ",
    "             -       #  --  # ",
    "             --      # ---- # ",
    "   --------------    # ---- # ",
    "   --------------    #  --  # ",
    "             --      ##    ## ",
    "             -        ######  ",
)
_INKS = {"#": BLACK, ".": _GREY, "-": _RED}

Rows = Sequence[str]


def of_joints(home: Rows, away: Rows) -> Picture:
    """An arm that moves its joints: where it was in grey, where it comes to, and a turned arrow."""
    ghost = ["".join(_WHITE if cell == _WHITE else _GREY for cell in row) for row in home]
    both = [
        "".join(b if a == _WHITE else a for a, b in zip(*rows, strict=True)) for rows in zip(away, ghost, strict=True)
    ]
    return _with_arrow(both, _TURNED)


def of_line(there: Rows) -> Picture:
    """An arm that goes straight on: where it begins, and a straight arrow."""
    return _with_arrow(there, _STRAIGHT)


def of_hand() -> Picture:
    """A hand that opens or closes."""
    return _in_the_middle(_HAND)


def of_opened() -> Picture:
    """A hand that is open."""
    return _in_the_middle(_OPENED)


def of_closed() -> Picture:
    """A hand that is closed."""
    return _in_the_middle(_CLOSED)


def of_goal() -> Picture:
    """A place straight on."""
    return _in_the_middle(_GOAL)


def of_goal_behind() -> Picture:
    """A place straight back."""
    return _in_the_middle([row[::-1] for row in _GOAL])


def of_base() -> Picture:
    """A base that drives on."""
    return _in_the_middle(_CAR)


def _with_arrow(rows: Rows, arrow: Rows) -> Picture:
    """With a red arrow in the corner where least is."""
    height, width = len(arrow), len(arrow[0])
    corners = [(y, x) for y in (2, SIZE - 2 - height) for x in (2, SIZE - 2 - width)]

    def hidden(corner: tuple[int, int]) -> int:
        y, x = corner
        return sum(cell != _WHITE for row in rows[y : y + height] for cell in row[x : x + width])

    top, left = min(corners, key=hidden)
    return _drawn([row.replace("#", "-") for row in arrow], rows, top, left)


def _in_the_middle(art: Rows) -> Picture:
    blank = [_WHITE * SIZE] * SIZE
    return _drawn(art, blank, (SIZE - len(art)) // 2, (SIZE - len(art[0])) // 2)


def _drawn(art: Rows, ground: Rows, top: int, left: int) -> Picture:
    """Signs as cells on what is there already."""
    cells = [list(row) for row in ground]
    for y, row in enumerate(art):
        for x, sign in enumerate(row):
            if sign in _INKS:
                cells[top + y][left + x] = _INKS[sign]
    return framed(["".join(row) for row in cells])
