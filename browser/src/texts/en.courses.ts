// English: courses of lessons.

export const enCourses = {
  'tutorial.course': 'Course',
  'tutorial.course.first': 'First steps',
  'tutorial.course.loops': 'Loops',
  'tutorial.course.branches': 'Branches',
  'tutorial.course.meetings': 'Flows that meet',
  'tutorial.course.arms': 'Two arms',
  'tutorial.course.nesting': 'Programs in programs',
  'tutorial.courseOver': 'That was this course. Another one stands above.',
  'tutorial.open': 'Open “{name}”',
  'tutorial.loopSee': 'See a loop that works',
  'tutorial.loopSeeHow': 'Open it and press Run. Read the sentences below: where does it go back to, and what decides?',
  'tutorial.twoActions': 'Make a program of two actions',
  'tutorial.twoActionsHow':
    'A new application of one flow: say “open the hand” and “close the hand”. No hole may be left.',
  'tutorial.loop': 'Repeat them',
  'tutorial.loopHow': 'Select both (Shift + arrow keys), right click, and take “Repeat … times”: twice.',
  'tutorial.loopRun': 'Run it, and see it come round',
  'tutorial.loopRunHow':
    'Press Run. It counts when the run is completed and an action in the loop was done at least twice.',
  'tutorial.loopWithin': 'Find out: how often is what stands in a loop within a loop done?',
  'tutorial.loopWithinHow':
    'Select the whole loop and repeat it again, twice. Say a number first, then run it and look at the counts at the icons. It counts when an action of the inner loop was done four times or more.',
  'tutorial.branchSee': 'See a branch that works',
  'tutorial.branchSeeHow':
    'Open it and press Run. Which of the two flows is taken, and what would have to be so that it takes the other?',
  'tutorial.branch': 'Put a branch into a program of your own',
  'tutorial.branchHow': 'Right click where it shall stand, and take “Insert a branch…”.',
  'tutorial.branchFlows': 'Give it a condition, and each of its flows an action',
  'tutorial.branchFlowsHow':
    'For example `LAMP == 1` for the first flow. What needs no target, such as “open the hand”, is quickest.',
  'tutorial.branchRun': 'Run it, and see which flow it takes',
  'tutorial.branchRunHow':
    'It counts when the run is completed and one flow of the branch was carried out, the other not.',
  'tutorial.branchMiddle': 'Find out: make a branch of three flows take the middle one',
  'tutorial.branchMiddleHow':
    'Insert another branch, of three flows with two conditions. The first condition that holds decides; try `GRIP_MEZ[0] < 0.05` behind “close the hand”, and change it until the middle one runs.',
  'tutorial.meetSee': 'See two flows that meet',
  'tutorial.meetSeeHow':
    'Open it and press Run. Two arms swing aside, and greet at the same instant, however long each took.',
  'tutorial.twoFlows': 'Make an application of two flows side by side',
  'tutorial.twoFlowsHow':
    'A new application, two flows, parallel; or “Add a flow” below the first one. Beside the name it must say “parallel”.',
  'tutorial.tags': 'Let them wait for each other',
  'tutorial.tagsHow':
    'Give each flow actions of its own arm. Right click an action of each, take “Synchronise…”, and give both the same tag.',
  'tutorial.meet': 'Run it, and see them meet',
  'tutorial.meetHow':
    'It counts when the run is completed and the flows have begun together at that tag: a line through both in the time line.',
  'tutorial.meetTwice': 'Find out: let them meet twice',
  'tutorial.meetTwiceHow':
    'A second tag, further on in both. What happens if the two tags stand in the opposite order in one of the flows? Try it: the page says so before anything moves. It counts when a completed run met at two tags.',
  'tutorial.armsSee': 'See two arms at work',
  'tutorial.armsSeeHow': 'Open it and press Run. Each flow moves an arm of its own, and none waits for the other.',
  'tutorial.armsFlows': 'Make a program for both arms',
  'tutorial.armsFlowsHow':
    'A new application of two flows, parallel. Into one “move the joints” and a target, into the other “move the joints of the right arm” and a target, such as “to the left, away from the table”. No hole may be left.',
  'tutorial.armsRun': 'Run it, and see both move',
  'tutorial.armsRunHow': 'It counts when the run is completed and both arms have done something.',
  'tutorial.armsWait': 'Find out: let one arm begin only when the other has finished a motion',
  'tutorial.armsWaitHow':
    'Where do the two tags have to stand? Put one at the first action of the arm that waits. It counts when the run is completed and they went on together there.',
  'tutorial.nestSee': 'See a program that is made of programs',
  'tutorial.nestSeeHow':
    'Open it and press Run. One picture goes there and waves: it is a whole program, and takes a target.',
  'tutorial.nestInside': 'Look inside one',
  'tutorial.nestInsideHow':
    'Hold Shift and click “go there and wave with the fingers”: what it is made of opens beside. The hole in it is what its target fills.',
  'tutorial.nestUse': 'Use it in a program of your own',
  'tutorial.nestUseHow': 'A new application: put “go there and wave with the fingers” into it, and a target behind it.',
  'tutorial.nestRun': 'Run that',
  'tutorial.nestRunHow': 'It counts when the run is completed. Shift + click looks inside while it runs.',
  'tutorial.nestOwn': 'Find out: make a picture of a program of your own, and use that',
  'tutorial.nestOwnHow':
    'Save a program, and take “As icon…” below its name. Then put the new picture into another program and run it. What does it have to leave open to take a target?',
}
