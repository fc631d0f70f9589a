// Español: por qué no se puede cambiar algo en una aplicación o en un diccionario (desk/upper/flow, desk/upper/dictionary).
// Todo lo que allí se niega está aquí; una prueba lo comprueba.
export const esHeardEdit: readonly (readonly [RegExp, string])[] = [
  // lo que ya no está
  [/^this application is no longer open$/, 'esta aplicación ya no está abierta'],
  [
    /^(.+) is running: nothing in it is changed until it has ended$/,
    '{0} se está ejecutando: no se cambia nada en ella hasta que termine',
  ],
  [/^what was selected is no longer there$/, 'lo que estaba seleccionado ya no está'],
  [/^nothing is selected$/, 'no hay nada seleccionado'],
  [/^this icon is no longer there$/, 'este icono ya no está'],
  [/^this flow is no longer there$/, 'este flujo ya no está'],
  [/^this branch is no longer there$/, 'esta bifurcación ya no está'],
  [/^the icon it should stand behind is no longer there$/, 'el icono detrás del cual iría ya no está'],
  [/^there is nothing to take back$/, 'no hay nada que deshacer'],
  [/^there is nothing to do again$/, 'no hay nada que rehacer'],
  // insertar, mover, copiar
  [/^no open dictionary has an icon (.+)$/, 'ningún diccionario abierto tiene un icono {0}'],
  [/^(.+) is (.+), which stands in no flow$/, '{0} es {1}, que no va en ningún flujo'],
  [
    /^a hole cannot be deleted: it closes as soon as what fits stands in it, or beside it$/,
    'un hueco no se puede borrar: se cierra en cuanto hay en él, o al lado, algo que encaje',
  ],
  [/^a hole cannot be copied$/, 'un hueco no se puede copiar'],
  [
    /^a hole is no icon: it goes where it is needed by itself$/,
    'un hueco no es un icono: aparece por sí solo donde hace falta',
  ],
  [/^nothing was copied yet$/, 'todavía no se ha copiado nada'],
  [/^this is no text of icons: ([^]+)$/, 'este texto no es de iconos: {=0}'],
  [/^expected the icons of one flow, found (.+) flows$/, 'se esperaban los iconos de un flujo, y hay {0}'],
  [/^at most (.+) branches may stand within each other$/, 'como mucho caben {0} bifurcaciones una dentro de otra'],
  [/^a branch cannot be moved into itself$/, 'una bifurcación no se puede mover dentro de sí misma'],
  // bifurcaciones y flujos
  [/^there are (.+) flows already, and no more can be had$/, 'ya hay {0} flujos, y no caben más'],
  [
    /^this branch chooses by conditions: one more flow would have none$/,
    'esta bifurcación elige por condiciones: otro flujo no tendría ninguna',
  ],
  [/^an application has at least one flow$/, 'una aplicación tiene al menos un flujo'],
  [/^a branch has at least one flow$/, 'una bifurcación tiene al menos un flujo'],
  [/^an application has (.+) flows, not (.+)$/, 'una aplicación tiene de {0} flujos, no {1}'],
  [/^a branch has (.+) flows, not (.+)$/, 'una bifurcación tiene de {0} flujos, no {1}'],
  [
    /^expected (.+) conditions for (.+) flows, or none, found (.+)$/,
    'se esperaban {0} condiciones para {1} flujos, o ninguna, y hay {2}',
  ],
  [/^this is no branch$/, 'esto no es una bifurcación'],
  // marcas y bucles
  [
    /^(.+) belongs to no action, and only actions bear marks$/,
    '{0} no pertenece a ninguna acción, y solo las acciones llevan marcas',
  ],
  [
    /^a branch bears no marks: mark an action before it, behind it or in it$/,
    'una bifurcación no lleva marcas: marque una acción antes, detrás o dentro de ella',
  ],
  [/^a tag is (.+), not (.+)$/, 'una etiqueta es {0}, no {1}'],
  [
    /^a loop goes back within one flow, and these two stand in different ones$/,
    'un bucle vuelve atrás dentro de un flujo, y estos dos están en flujos distintos',
  ],
  [
    /^a loop has two actions: one that decides, and one that is gone back to$/,
    'un bucle tiene dos acciones: la que decide y aquella a la que se vuelve',
  ],
  [/^there is a loop (.+) in this flow already$/, 'ya hay un bucle {0} en este flujo'],
  [
    /^this loop would cross the loop (.+): one has to lie within the other$/,
    'este bucle se cruzaría con el bucle {0}: uno debe quedar dentro del otro',
  ],
  [/^(.+) is part of no loop$/, '{0} no forma parte de ningún bucle'],
  [/^this is no condition$/, 'esto no es una condición'],
  // cambiar un icono
  [/^only icons can be changed$/, 'solo se pueden cambiar iconos'],
  [/^(.+) is (.+), which has no values$/, '{0} es {1}, que no tiene valores'],
  [/^the picture cannot be kept: ([^]+)$/, 'el dibujo no se puede guardar: {=0}'],
  // archivos
  [
    /^there are no types of icons: the definition (.+) could not be read$/,
    'no hay tipos de iconos: no se pudo leer la definición {0}',
  ],
  [
    /^there is no syntax definition, which says what types of icons there are$/,
    'no hay definición de sintaxis, que dice qué tipos de iconos existen',
  ],
  [/^(.+) has no file yet: an icon is made of one$/, '{0} aún no tiene archivo: de él se hace un icono'],
  [/^(.+) has no file yet$/, '{0} aún no tiene archivo'],
  [
    /^it has no file yet: give it a name and a base directory$/,
    'aún no tiene archivo: dele un nombre y un directorio base',
  ],
  [/^what could not be read of (.+) would be lost: ([^]+)$/, 'se perdería lo que no se pudo leer de {0}: {=1}'],
  [/^(.+) cannot be saved: ([^]+)$/, '{0} no se puede guardar: {=1}'],
  [/^(.+) is not saved$/, '{0} no está guardada'],
  [/^(.+) is no file$/, '{0} no es un archivo'],
  [/^there is no file (.+)$/, 'no hay ningún archivo {0}'],
  [
    /^(.+) stands in no folder appl\/ of a base directory: what it names could not be found$/,
    '{0} no está en una carpeta appl/ de un directorio base: no se encontraría lo que nombra',
  ],
  [
    /^(.+) is no name of an application: expected letters, digits and _ \. -, a letter first$/,
    '{0} no sirve como nombre de aplicación: se esperan letras, cifras y _ . -, primero una letra',
  ],
  [/^(.+) is no name for a file$/, '{0} no sirve como nombre de archivo'],
  [
    /^no base directory on the search path has an application (.+)$/,
    'ningún directorio base de la ruta de búsqueda tiene una aplicación {0}',
  ],
  [/^(.+) would be part of Onika itself there$/, '{0} formaría allí parte de Onika misma'],
  [/^([^]+); mend it and save it first$/, '{=0}; corríjalo y guárdelo antes'],
  // diccionarios
  [/^the dictionary (.+) is not open$/, 'el diccionario {0} no está abierto'],
  [/^(.+) cannot be opened: ([^]+)$/, '{0} no se puede abrir: {=1}'],
  [/^(.+) is part of Onika itself$/, '{0} forma parte de Onika misma'],
  [/^(.+) comes with Onika and stays$/, '{0} viene con Onika y se queda'],
  [/^(.+) cannot be deleted: (.+)$/, '{0} no se puede borrar: {1}'],
  [
    /^there is no home directory: say in which base directory it is to be$/,
    'no hay directorio personal: diga en qué directorio base debe estar',
  ],
  [/^there is no type (.+)$/, 'no hay ningún tipo {0}'],
  [/^(.+) is no type of target$/, '{0} no es un tipo de objetivo'],
  [
    /^no task that takes (.+) measures anything like it: its values are typed in$/,
    'ninguna tarea que admite {0} mide algo parecido: sus valores se escriben',
  ],
  [/^no robot is connected: nothing is measured$/, 'no hay ningún robot conectado: no se mide nada'],
  [/^nothing in (.+) measures (.+) now$/, 'nada en {0} mide ahora {1}'],
  [/^nothing that runs measures (.+) now$/, 'nada de lo que está en marcha mide ahora {0}'],
  [/^what is measured does not fit: ([^]+)$/, 'lo medido no encaja: {=0}'],
]
