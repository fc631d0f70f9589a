// English: runs that are recorded, gone on from in the simulator, kept as tests.
export const enRecording = {
  'recording.record': 'Record',
  'recording.recordHint':
    'Write the run down in a file, to look at it afterwards. It costs a twentieth of a processor core at most.',
  'recording.recordOn': 'The next run is recorded',
  'recording.recordOff': 'The next run is not recorded',
  'recording.going': 'Recording',
  'recording.goingHint': 'This run is written to {path}',
  'recording.file': 'Recorded: {file} ({size})',
  'recording.gone': 'Recorded: {file}, which is no longer there',
  'recording.look': 'Look at the recording',
  'recording.keep': 'Keep as a test…',
  'recording.keepHint': 'Later changes are then checked against this run',

  'recording.simulator': 'Simulator',
  'recording.repeats': 'Repeats the recording up to {n} s',
  'recording.repeatsHint': 'Until then it is the recorded run: it can be ended, not steered.',
  'recording.goesOn': 'Simulated: the recorded run up to {n} s, then on from there.',
  'recording.leave': 'Leave the simulator',
  'recording.leaveHint':
    'Ends the simulator with all that lives there and starts the usual runtime, its workcell as at first',

  'keep.title': 'Keep {name} as a test',
  'keep.about':
    'It is run {n} times in simulators, aside: the robot does nothing. What all runs have in common is written down, and “onika test” checks it from then on.',
  'keep.name': 'Name',
  'keep.nameHint': 'a name, or the path of a .test file',
  'keep.expects': 'At the end',
  'keep.expectsHint': 'LAMP == 1',
  'keep.expectsWords': 'What must hold when it is done. It may stay empty.',
  'keep.expectsOf': 'What must hold at the end, {n}',
  'keep.more': 'Add another',
  'keep.begin': 'Keep',
  'keep.again': 'Keep again',
  'keep.close': 'Close',
  'keep.beginning': 'Beginning',
  'keep.run': 'Run {n} of {of}',
  'keep.goesOn': 'You may close this. You are told when it is done.',
  'keep.kept': 'Kept: {text}',
  'keep.failed': 'Not kept',
  'keep.check': 'Check it with',
  'keep.other': '{file} is being kept now. One test is kept at a time.',
}
