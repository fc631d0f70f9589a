// English: steps in the inputs of hardware where what drives it is exchanged.
export const enContinuity = {
  'continuity.smooth': 'Smooth: the largest step at a switch was {n} % of what is allowed ({name}).',
  'continuity.smoothHint': '{step} at {at} s; one cycle may change it by {limit}',
  'continuity.blended':
    '{name} stepped by {step} at {at} s, more than the {limit} of one cycle. It was blended over {n} cycle.|{name} stepped by {step} at {at} s, more than the {limit} of one cycle. It was blended over {n} cycles.',
  'continuity.more': 'At {n} switch steps were blended.|At {n} switches steps were blended.',
  'continuity.refused':
    '{name} would have stepped by {step} at {at} s, too far to blend at {limit} in one cycle: the drive held.',
  'continuity.unknown': '{name} stepped by {step} at most; {task} does not say how far it may.',
}
