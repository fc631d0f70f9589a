"""What a person does with tasks that live, and where they are shown."""

import re


def place(me, *tasks, unit="rt0"):
    for task in tasks:
        k = me.canvas.locator("[data-task]").count()
        me.drag(me.icon(task), 140 + 230 * (k % 4), 120 + 200 * (k // 4))
        me.page.get_by_role("dialog", name=f"On which processing unit shall {task} live?").get_by_role(
            "button", name=re.compile(f"^{unit}")
        ).click()
        me.state(task, "OFF")


def turn(me, *tasks, state="ON"):
    for task in tasks:
        me.box(task).click(modifiers=["Shift"])
        me.state(task, state)


def row(me, task):
    return me.strip.get_by_role("row", name=re.compile(rf"^{task} "))
