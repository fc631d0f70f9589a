// What the environment says as a bare text stays as it was said where nothing is known of it.
import { expect, test } from 'vitest'
import { heard } from '../../src/texts/heard'

test.each(['its data is asked for while it runs', 'the sensor is dead'])('%s', (text) =>
  expect(heard(text, 'es')).toBe(text),
)
