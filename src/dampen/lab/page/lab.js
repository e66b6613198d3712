function ot(i,t={},...e){let n=document.createElement(i);for(let[s,r]of Object.entries(t))typeof r=="function"?n.addEventListener(s.slice(2),r):r===!0?n.setAttribute(s,""):r!==void 0&&r!==!1&&n.setAttribute(s,String(r));return n.append(...e),n}function Un(i){let t=document.getElementById(i);if(!t)throw new Error(`The page has no #${i}.`);return t}function On(i,t){i.textContent!==t&&(i.textContent=t)}var gx=0,am=()=>`e${++gx}`;function lm(i){let t=Un("drop"),e=n=>n.dataTransfer?.types.includes("Files")??!1;addEventListener("dragover",n=>{e(n)&&(n.preventDefault(),t.hidden=!1)}),addEventListener("dragleave",n=>{n.relatedTarget===null&&(t.hidden=!0)}),addEventListener("drop",n=>{t.hidden=!0;let[s]=n.dataTransfer?.files??[];s&&(n.preventDefault(),i(s))})}async function cm(i){let t=await um(new TextEncoder().encode(JSON.stringify(i)),new CompressionStream("deflate-raw")),e=Array.from(t,n=>String.fromCharCode(n)).join("");return`#s=${btoa(e).replaceAll("+","-").replaceAll("/","_").replaceAll("=","")}`}async function hm(i){let[,t]=/^#s=(.*)$/.exec(i)??[];if(t===void 0)return null;let e=atob(t.replaceAll("-","+").replaceAll("_","/")),n=Uint8Array.from(e,o=>o.charCodeAt(0)),s=await um(n,new DecompressionStream("deflate-raw")),r=JSON.parse(new TextDecoder().decode(s));if(r?.v!==1||typeof r.preset!="string"||typeof r.table!="object"||r.table===null)throw new Error("The link holds no state.");return{v:1,preset:r.preset,table:r.table,view:r.view??{}}}async function um(i,t){let e=new Blob([i]).stream().pipeThrough(t).getReader(),n=[],s=0;for(let a=await e.read();!a.done;a=await e.read())if(n.push(a.value),s+=a.value.length,s>4e6)throw new Error("The link holds too much.");let r=new Uint8Array(s),o=0;for(let a of n)r.set(a,o),o+=a.length;return r}var _x=600,wl=class{constructor(t){this.state=t}state;timer=0;read(){return hm(location.hash)}renew(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{this.write()},_x)}async write(){history.replaceState(null,"",await cm(this.state()))}};var yx=/\[(\d+)\]|"((?:[^"\\]|\\.)*)"|([^.[\]"]+)/g;function hd(i){return[...i.matchAll(yx)].map(([,t,e,n])=>t!==void 0?Number(t):e!==void 0?JSON.parse(`"${e}"`):n)}function yn(i){let t="";for(let e of i)typeof e=="number"?t+=`[${e}]`:t+=(t?".":"")+(/^[\w-]+$/.test(e)?e:JSON.stringify(e));return t}var Ve=i=>typeof i=="object"&&i!==null&&!Array.isArray(i);function dm(i,t){return Array.isArray(i)?typeof t=="number"?i[t]:void 0:Ve(i)&&Object.hasOwn(i,t)?i[t]:void 0}var Qr=(i,t)=>t.reduce(dm,i);function oa(i,t,e){let[n,...s]=t;if(n===void 0)return e;let r=oa(dm(i,n),s,e);return typeof n=="number"?Object.assign(Array.isArray(i)?[...i]:[],{[n]:r}):{...Ve(i)?i:{},[n]:r}}function ud(i,t){let e=t.slice(0,-1),n=Qr(i,e),s=t[t.length-1];if(s===void 0||Qr(i,t)===void 0)return i;if(Array.isArray(n))return oa(i,e,n.filter((l,c)=>c!==s));let{[s]:r,...o}=n;return Object.keys(o).length===0&&typeof e[e.length-1]=="string"?ud(i,e):oa(i,e,o)}function Si(i,t){if(i===t)return!0;if(Array.isArray(i))return Array.isArray(t)&&i.length===t.length&&i.every((n,s)=>Si(n,t[s]));if(!Ve(i)||!Ve(t))return!1;let e=Object.keys(i);return e.length===Object.keys(t).length&&e.every(n=>Object.hasOwn(t,n)&&Si(i[n],t[n]))}function aa(i,t,e=[]){return Si(i,t)?[]:Ve(i)&&Ve(t)&&i.kind===t.kind?[...new Set([...Object.keys(i),...Object.keys(t)])].flatMap(s=>aa(i[s],t[s],[...e,s])):fm(i)&&fm(t)&&i.length===t.length?i.flatMap((n,s)=>aa(n,t[s],[...e,s])):[{path:e,before:i,after:t}]}var fm=i=>Array.isArray(i)&&i.every(Ve);function vr(i){if(i===void 0)return"left out";if(Array.isArray(i))return`[${i.map(vr).join(", ")}]`;if(!Ve(i))return String(i).replace(/^-(?=\d)/,"−");let{kind:t,...e}=i,n=Object.entries(e).map(([s,r])=>`${s} = ${vr(r)}`);return[...t===void 0?[]:[String(t)],...n].join(", ")||"empty"}function pm(i,t,e){let n=aa(e,t),s=n.slice(0,2).map(({path:o,after:a})=>{let l=Ve(a)&&a.kind!==void 0?String(a.kind):vr(a);return`${o[o.length-1]} = ${l.length>24?`${l.slice(0,22)}…`:l}`}),r=n.length>s.length?[`${n.length-s.length} more`]:[];return[i,...s,...r].join(", ")}var Tl=class{constructor(t,e,n){this.schema=t;this.scenario=e;this.attach=n}schema;scenario;attach;ports=[];sliders={};kinds(t){return this.schema.kinds[t]??[]}};var El=class{constructor(t){this.form=t}form;element=ot("div",{class:"changes",hidden:!0});count_=0;get count(){return this.count_}update(){let{scenario:t}=this.form,e=aa(t.preset.table,t.table);if(this.count_=e.length,this.element.hidden)return;let n=ot("p",{class:"about"},`Nothing differs from ${t.preset.name}.`);this.element.replaceChildren(e.length===0?n:ot("ul",{},...e.map(s=>this.line(s))))}show(t){this.element.hidden=!t,this.update()}line({path:t,before:e,after:n}){let s=yn(t);return ot("li",{},ot("code",{},s),ot("span",{class:"values"},ot("del",{},gm(e))," → ",ot("ins",{},gm(n))),ot("button",{type:"button",class:"quiet","aria-label":`Revert ${s}`,onclick:()=>this.form.scenario.revert(t)},"revert"))}},mm=60;function gm(i){let t=vr(i);return t.length>mm?`${t.slice(0,mm)}…`:t}var xx="-0123456789n",vx="⁻⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ",to=i=>i.replace(/\^(-?[\dn]+)/g,(t,e)=>[...e].map(n=>vx[xx.indexOf(n)]).join(""));function la(i){let t=i.trim().replace(/^−/,"-").replace(/e−/i,"e-");return/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(t)?Number(t):void 0}var dd=(i,t)=>Number(i.toPrecision(t)),vs=i=>String(dd(i,6)).replaceAll("-","−"),_m=i=>i<1?`${Math.max(1,Math.round(i*1e3))} ms`:`${i.toFixed(i<10?1:0)} s`;var kn=i=>i.split("`").map((t,e)=>e%2===1?ot("code",{},t):t),Al=i=>i.replaceAll("`","");function ym({doc:i,range:t,default:e,required:n,unit:s}){let r=[i,bx(t),s&&`In ${to(s)}`];return n?r.push("Needed"):ca(e)||r.push(`Default ${typeof e=="number"?vs(e):vr(e)}`),r.filter(Boolean).map(Sx).join(" ")}function bx({gt:i,ge:t,lt:e,le:n}){let s=i!==void 0?`greater than ${vs(i)}`:t!==void 0?`at least ${vs(t)}`:"",r=e!==void 0?`less than ${vs(e)}`:n!==void 0?`at most ${vs(n)}`:"";return[s,r].filter(Boolean).join(", ")}var Sx=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.;:!?]$/.test(i)?"":"."),ca=i=>i===void 0||i===""||typeof i=="object"&&Object.keys(i).length===0;function xm(i,{unit:t,doc:e}){let n=[...e.matchAll(/\[([^\]]+,[^\]]+)\]/g)].pop()?.[1]??"",s=t||n,[r,o]=s.split(",").map(a=>a.trim());return o===void 0?r??"":(i?.kind==="torque"?o:i&&r)||""}function vm(i){switch(i.is){case"number":case"integer":return"number";case"list":return i.of.is==="list"?"matrix":"list";case"component":return"table";case"kind":return i.family;case"function":return"code of your own";default:return i.is}}function bm(i,t){let e=[...i.querySelectorAll("[data-error]:not([data-typed])")].map(r=>({element:r,path:hd(r.dataset.error??"")})),n=new Map(e.map(({element:r})=>[r,[]])),s=[];for(let r of t){let o=hd(r.at),[a]=e.filter(l=>Mx(o,l.path)).sort((l,c)=>c.path.length-l.path.length);a?n.get(a.element)?.push(a.path.length<o.length?`${r.at} ${r.text}`:r.text):s.push(r)}for(let[r,o]of n)r.replaceChildren(...kn(o.join(" "))),wx(i,r,o.length>0);return s}var Mx=(i,t)=>t.length>0&&t.every((e,n)=>e===i[n]);function wx(i,t,e){if(t.id&&i.querySelector(`[data-path][aria-describedby~="${t.id}"]`)?.setAttribute("aria-invalid",String(e)),!!e)for(let n=t.closest("details");n;n=n.parentElement?.closest("details")??null)n.open=!0}var Rl=class{constructor(t){this.root=t}root;folds=null;apply(t){let e=t.toLowerCase().split(/\s+/).filter(Boolean);if(this.root.classList.toggle("filtering",e.length>0),e.length===0){for(let n of this.root.querySelectorAll("[data-passed]"))delete n.dataset.passed;return this.folds?.forEach((n,s)=>s.open=n),this.folds=null,null}return this.folds??=new Map([...this.root.querySelectorAll("details")].map(n=>[n,n.open])),fd(this.root,n=>e.every(s=>n.includes(s)),!1)}};function fd(i,t,e){let n=0;for(let s of i.children){if(!(s instanceof HTMLElement))continue;let{words:r,group:o}=s.dataset,a=e||r!==void 0&&t(r);if(r===void 0&&o===void 0){n+=fd(s,t,e);continue}let l=o===void 0?0:fd(s,t,a),c=l>0||a;s.dataset.passed=String(c),c&&s instanceof HTMLDetailsElement&&(s.open=!0),n+=l>0?l:Number(a)}return n}var Cl=class{constructor(t,e,n){this.form=t;this.plan=e;let{key:s,title:r}=e;this.wanted=!e.onDemand,this.field=e.make(t),this.add=ot("button",{type:"button",class:"add",onclick:()=>this.unfold()},`Add ${r.toLowerCase()}`),this.details=ot("details",{class:"section","data-group":"","data-section":s,open:n},ot("summary",{},ot("h2",{},r),this.mark,this.gist),ot("p",{class:"about"},...kn(t.schema.tables[s]?.summary??"")),this.remark,ot("p",{class:"error","data-error":s}),this.field.element),this.element=ot("div",{},this.add,this.details),this.update()}form;plan;element;details;add;gist=ot("span",{class:"gist"});mark=ot("span",{class:"mark",hidden:!0},ot("span",{class:"unseen"},"changed from the preset"));remark=ot("p",{class:"about"});field;wanted;update(){let{form:t,plan:e}=this,n=t.scenario.value([e.key]),s=this.wanted||n!==void 0;this.details.hidden=!s,this.add.hidden=s,this.mark.hidden=!t.scenario.differs([e.key]),On(this.gist,Ve(n)&&typeof n.kind=="string"?n.kind:""),On(this.remark,e.remark?.(t.scenario.table)??""),this.field.update()}unfold(){this.wanted=!0,this.update(),this.details.open=!0,this.details.querySelector("summary")?.focus()}};var Pl=class{constructor(t,e,n,s){this.form=t;this.path=e;this.parameter=n;this.types=s;let r=s.filter(({is:l})=>l!=="function"),o=s.map((l,c)=>ot("option",{value:c,disabled:l.is==="function"},vm(l))),a={"aria-label":`${n.name}: form`,"data-form":yn(e)};this.select=ot("select",{class:"form",...a},...o),this.select.addEventListener("change",()=>this.choose(Number(this.select.value))),this.select.hidden=r.length<2,this.update()}form;path;parameter;types;element=ot("div",{});select;chosen=-1;inner=null;seen;update(){let t=this.form.scenario.value(this.path),e=this.chosen>=0&&t===this.seen&&t===void 0;this.seen=t;let n=e?this.chosen:this.formOf(t??this.parameter.default);n!==this.chosen?this.build(n):this.inner?.update()}formOf(t){let e=this.types.findIndex(s=>t!==void 0&&ha(s,t)),n=typeof t=="string"?this.types.findIndex(({is:s})=>s==="function"):-1;return e>=0?e:Math.max(0,n)}build(t){let e=this.types[t];if(!e)return;this.chosen=t,this.select.value=String(t);let{default:n,...s}=this.parameter,r=n!==void 0&&ha(e,n)?{default:n}:{},o={...s,...r,type:e};this.inner=e.is==="component"?new pd(this.form,this.path,e):eo(this.form,this.path,o),this.element.replaceChildren(this.inner.element),this.element.querySelector(".naming")?.append(this.select)}choose(t){let e=this.types[t];if(!e)return;let n=Tx(this.form.scenario.value(this.path)??this.parameter.default,e,this.form);this.build(t),n===void 0?this.form.scenario.remove(this.path):this.form.scenario.set(this.path,n),this.seen=this.form.scenario.value(this.path),this.chosen!==t&&this.build(t),this.select.focus()}},pd=class{element;inner;constructor(t,e,n){this.inner=new Fi(t,e,n.parameters);let s=String(e[e.length-1]);this.element=ot("div",{class:"unfolded","data-group":"",role:"group","aria-label":s},ot("div",{class:"naming"},ot("span",{class:"name"},s)),ot("p",{class:"about"},...kn(n.summary)),ot("p",{class:"error","data-error":yn(e)}),this.inner.element)}update(){this.inner.update()}};function ha(i,t){switch(i.is){case"number":case"integer":return typeof t=="number";case"boolean":return typeof t=="boolean";case"text":case"file":return typeof t=="string";case"choice":return typeof t=="string"&&i.of.includes(t);case"list":return Array.isArray(t)&&t.every(e=>ha(i.of,e));case"kind":return Ve(t)&&"kind"in t;case"table":case"component":return Ve(t)&&!("kind"in t);case"any":return i.of.some(e=>ha(e,t));case"function":return!1}}function Tx(i,t,e){let n=Array.isArray(i)?i[i.length-1]:i;switch(t.is){case"number":case"integer":return typeof n=="number"?n:void 0;case"list":return typeof n=="number"&&t.of.is==="number"?[n]:void 0;case"kind":{let[s]=e.kinds(t.family);return s&&{kind:s.kind}}case"component":{let s=t.parameters.find(({required:r})=>r);return s&&n!==void 0&&ha(s.type,n)?{[s.name]:n}:void 0}default:return}}var br=class extends Error{constructor(e){super(e.map(({at:n,text:s})=>n?`${n} ${s}`:s).join(" "));this.faults=e}faults},Ex={"X-Dampen":"lab"},Sm=()=>gd("/schema"),Mm=()=>gd("/start"),md=i=>gd(`/scenario/${encodeURIComponent(i)}`);async function wm(i){return await(await _d(`/read?name=${encodeURIComponent(i.name)}`,i)).json()}async function Tm(i){return(await(await _d(`/attach?name=${encodeURIComponent(i.name)}`,i)).json()).attachment}async function Em(i,t){let e=await _d(`/download/${i}`,JSON.stringify({table:t})),n=/filename="?([^";]+)"?/.exec(e.headers.get("Content-Disposition")??"")?.[1]??`dampen-${i}`,s=URL.createObjectURL(await e.blob()),r=document.createElement("a");r.href=s,r.download=n,r.click(),setTimeout(()=>URL.revokeObjectURL(s),6e4)}async function gd(i){let t=await fetch(i);if(!t.ok)throw new Error(`The server has no ${i}.`);return await t.json()}async function _d(i,t){let n=await fetch(i,{method:"POST",headers:{...Ex,"Content-Type":typeof t=="string"?"application/json":"application/octet-stream"},body:t});if(n.ok)return n;let s=await n.json().catch(()=>null);throw new br(s?.faults??[{at:"",text:`The server could not do this (${n.status}).`}])}var Ln=class{constructor(t,e,n,s=!1){this.form=t;this.path=e;this.parameter=n;this.group=s;this.at=yn(e),this.error=ot("p",{class:"error",id:`${this.id}-error`,"data-error":this.at});let r=s?ot("span",{class:"name",id:`${this.id}-name`},n.name):ot("label",{class:"name",for:this.id},n.name),o=ot("p",{class:"help",id:`${this.id}-help`},...kn(ym(n)));this.reset=ot("button",{type:"button",class:"quiet",hidden:!0,onclick:()=>t.scenario.remove(e)}),this.element=ot("div",{class:"field","data-at":this.at,"data-words":`${this.at} ${n.doc}`.toLowerCase()},ot("div",{class:"naming"},r,this.mark,ot("span",{class:"unit"},to(n.unit)),ot("span",{class:"brief","aria-hidden":"true"},Al(n.doc)),this.reset,...n.doc?[Ax(n.name,o)]:[]),this.body,o,this.error),s&&(this.element.setAttribute("role","group"),this.element.setAttribute("aria-labelledby",`${this.id}-name`),this.element.setAttribute("aria-describedby",this.descriptions))}form;path;parameter;group;element;body=ot("div",{class:"entry"});id=am();at;mark=ot("span",{class:"mark",hidden:!0},ot("span",{class:"unseen"},"changed from the preset"));error;reset;get control(){let{id:t,at:e}=this;return{id:t,"data-path":e,"aria-describedby":this.descriptions,autocomplete:"off",spellcheck:"false"}}get slider(){return{"data-slider":this.at,"aria-label":`${this.parameter.name}, slider`,"aria-describedby":this.descriptions}}update(){let{form:t,path:e,parameter:n}=this;this.mark.hidden=!t.scenario.differs(e);let s=t.scenario.value(e);this.reset.hidden=n.required||s===void 0||Si(s,n.default);let r=ca(n.default)?"leave out":"default";On(this.reset,r);let o=r==="default"?`${n.name}: back to the default`:`${n.name}: leave out`;this.reset.setAttribute("aria-label",o)}fail(t){let e="typed"in this.error.dataset;!t&&!e||(this.error.toggleAttribute("data-typed",t!==""),On(this.error,t),this.group||this.body.querySelector(`#${this.id}`)?.setAttribute("aria-invalid",String(t!=="")))}get descriptions(){return`${this.id}-help ${this.id}-error`}};function Ax(i,t){let e=ot("button",{type:"button",class:"ask","aria-label":`What is ${i}?`,"aria-expanded":"false","aria-controls":t.id},"?");return e.addEventListener("click",()=>{let n=e.getAttribute("aria-expanded")!=="true";e.setAttribute("aria-expanded",String(n)),t.classList.toggle("open",n)}),e}var yd="",Il=class{constructor(t,e,n,s){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let{required:r,default:o}=n,a=r?"needed":o===void 0?"left out":`${String(o)} (default)`,l=s.map(c=>ot("option",{value:c},c));this.select=ot("select",this.row.control,ot("option",{value:yd},a),...l),this.select.addEventListener("change",()=>{this.select.value===yd?t.scenario.remove(e):t.scenario.set(e,this.select.value)}),this.row.body.append(this.select),this.update()}form;path;element;row;select;update(){this.row.update();let t=this.form.scenario.value(this.path);this.select.value=t===void 0?yd:String(t)}},Ll=class{constructor(t,e,n){this.form=t;this.path=e;this.parameter=n;this.row=new Ln(t,e,n),this.element=this.row.element,this.input=ot("input",{type:"checkbox",role:"switch",...this.row.control}),this.input.addEventListener("change",()=>t.scenario.set(e,this.input.checked)),this.row.body.append(this.input,this.word),this.update()}form;path;parameter;element;row;input;word=ot("span",{class:"word","aria-hidden":"true"});update(){this.row.update(),this.input.checked=(this.form.scenario.value(this.path)??this.parameter.default)===!0,On(this.word,this.input.checked?"yes":"no")}},Dl=class{constructor(t,e,n){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let s=ot("input",{type:"file",...this.row.control,onchange:()=>{this.take(s)}});this.row.body.append(this.name,s),this.update()}form;path;element;row;name=ot("output",{class:"file"});update(){this.row.update(),On(this.name,String(this.form.scenario.value(this.path)??"no file yet"))}async take(t){let[e]=t.files??[];if(e){this.row.fail("");try{this.form.scenario.set(this.path,await this.form.attach(e))}catch(n){this.row.fail(n instanceof br?n.message:"The file did not reach the server.")}t.value=""}}},Nl=class{constructor(t,e,n){this.form=t;this.path=e;this.row=new Ln(t,e,n),this.element=this.row.element;let s="code of your own: edit the scenario file";this.input=ot("input",{type:"text",disabled:!0,placeholder:s,...this.row.control}),this.row.body.append(this.input),this.update()}form;path;element;row;input;update(){this.row.update();let t=this.form.scenario.value(this.path);this.input.value=t===void 0?"":String(t),this.input.title=yn(this.path)}};var Fl="",Xs=class{constructor(t,e,n,s){this.form=t;this.path=e;this.family=s;let r=[...e,"kind"];this.row=new Ln(t,n.required?r:e,n);let o=t.kinds(s),a=n.required?"needed":"left out";this.select=ot("select",{...this.row.control,"data-path":yn(r)},ot("option",{value:Fl},a),...o.map(({kind:l})=>ot("option",{value:l},l))),this.select.addEventListener("change",()=>{this.select.value===Fl?t.scenario.remove(e):t.scenario.set(e,{kind:this.select.value})}),this.row.body.append(this.select),this.element=ot("div",{class:"kind","data-group":""},this.row.element,this.about,this.body),this.update()}form;path;family;element;row;select;about=ot("p",{class:"about"});body=ot("div",{});inner=null;shown=null;update(){this.row.update();let t=String(this.form.scenario.value([...this.path,"kind"])??Fl);t!==this.shown?this.build(t):this.inner?.update()}build(t){this.shown=t,this.select.value=t;let e=this.form.kinds(this.family).find(s=>s.kind===t),n=t===Fl?"":`“${t}” is code of your own: edit the scenario file.`;this.about.replaceChildren(...kn(e?.summary??n)),this.inner=e?new Fi(this.form,this.path,e.parameters):null,this.body.replaceChildren(...this.inner?[this.inner.element]:[])}};var ua=1e3,Am=30,Rx=3,Cx=10;function xd(i,{type:t,range:e}){if(i===void 0)return null;let n=t.is==="integer",s=e.ge??e.gt??-1/0,r=e.le??e.lt??1/0,o=Number.isFinite(s)&&Number.isFinite(r),a=n&&r-s>Cx*Math.abs(i);if(o&&!a)return{low:s,high:r,log:!1,whole:n};if(i===0)return null;if(i>0)return{low:Math.max(i/Am,s,n?1:0),high:Math.min(i*Am,r),log:!0,whole:n};let l=Rx*Math.abs(i);return{low:Math.max(-l,s),high:Math.min(l,r),log:!1,whole:n}}var Rm=(i,t)=>i.low<=t&&t<=i.high;function Cm({low:i,high:t,log:e},n){let s=e?Math.log(n/i)/Math.log(t/i):(n-i)/(t-i);return Math.round(ua*Math.min(1,Math.max(0,Number.isNaN(s)?0:s)))}function vd({low:i,high:t,log:e,whole:n},s){let r=s/ua,o=e?i*(t/i)**r:i+(t-i)*r;if(n)return Math.round(o);if(e)return dd(o,3);let a=Math.max(0,Math.ceil(-Math.log10((t-i)/ua)));return Number(o.toFixed(Math.min(a,20)))}function Ul(i,t,e){let n=0;i.addEventListener("input",()=>{clearTimeout(n),/(^|[\s,])[-−+.]?$|[.e]$|e[-−+]$/i.test(i.value)||(n=window.setTimeout(t,350))}),i.addEventListener("change",()=>{clearTimeout(n),t(),e()})}var Ol=class{constructor(t,e,n){this.form=t;this.path=e;this.parameter=n;this.at=yn(e),this.row=new Ln(t,e,n),this.element=this.row.element,this.slider=ot("input",{type:"range",min:0,max:ua,step:1,hidden:!0,...this.row.slider}),this.input=ot("input",{type:"text",inputmode:(n.range.ge??n.range.gt??-1)>=0?"decimal":"text",placeholder:this.placeholder,"aria-required":n.required?"true":void 0,...this.row.control}),this.row.body.append(this.slider,this.input),this.slider.addEventListener("input",()=>this.slide()),this.slider.addEventListener("change",()=>t.scenario.settle()),Ul(this.input,()=>this.typed(),()=>t.scenario.settle()),this.update()}form;path;parameter;element;row;input;slider;at;scale=null;update(){let t=this.form.scenario.value(this.path);this.row.update(),this.show(t);let e=t??this.parameter.default,n=typeof e=="number"?e:void 0;(document.activeElement!==this.slider||!this.holds(n))&&this.rescale(n),this.slider.hidden=this.scale===null,this.slider.classList.toggle("unset",t===void 0),!(!this.scale||n===void 0)&&(vd(this.scale,Number(this.slider.value))!==n&&(this.slider.value=String(Cm(this.scale,n))),this.slider.setAttribute("aria-valuetext",`${vs(n)} ${to(this.parameter.unit)}`.trim()))}get placeholder(){let{required:t,default:e}=this.parameter;return t?"needed":typeof e=="number"?vs(e):"left out"}show(t){let e=t===void 0?"":String(t);this.input.value!==e&&(e===""||la(this.input.value)!==t)&&(this.input.value=e,this.row.fail(""))}rescale(t){let e=this.form.sliders[this.at];e&&t!==void 0&&e.low<=t&&t<=e.high?this.scale={...e,whole:this.parameter.type.is==="integer"}:this.holds(t)||(this.scale=xd(t,this.parameter))}holds(t){return this.scale!==null&&(t===void 0||Rm(this.scale,t))}slide(){this.scale&&this.form.scenario.set(this.path,vd(this.scale,Number(this.slider.value)),`slide ${this.at}`)}typed(){if(this.input.value.trim()===""){this.row.fail(""),this.form.scenario.remove(this.path);return}let t=la(this.input.value),e=this.parameter.type.is==="integer";if(t===void 0)return this.row.fail("This is not a number.");if(e&&!Number.isInteger(t))return this.row.fail("This must be a whole number.");this.row.fail(""),this.form.sliders[this.at]||(this.scale=xd(t,this.parameter)),this.form.scenario.set(this.path,t,`type ${this.at}`)}};var no=class{constructor(t,e,n,s,r={}){this.form=t;this.path=e;this.parameter=n;this.of=s;this.more=r;this.row=new Ln(t,e,{...n,unit:""},!0),this.row.body.append(this.rows),this.element=this.row.element,this.element.setAttribute("data-group",""),this.update()}form;path;parameter;of;more;element;row;rows=ot("div",{class:"by-port"});fields=[];names="";update(){this.row.update();let t=this.form.scenario.value(this.path),e=this.form.ports.map(({name:r})=>r),n=new Set([...e,...Object.keys(this.more),...Ve(t)?Object.keys(t):[]]),s=JSON.stringify([...n].map(r=>[r,this.unit(r)]));if(s===this.names){for(let r of this.fields)r.update();return}this.names=s,this.fields=[...n].map(r=>this.field(r)),this.rows.replaceChildren(...this.fields.map(r=>r.element))}unit(t){return this.more[t]??xm(this.form.ports.find(e=>e.name===t),this.parameter)}field(t){let{range:e}=this.parameter,n={name:t,type:this.of,unit:this.unit(t),doc:"",range:e,required:!1};return eo(this.form,[...this.path,t],n)}};var Px={write:String,read:i=>i.trim()},Ix=i=>({write:t=>Array.isArray(t)?t.map(String).join(", "):String(t),read:t=>{let e=t.replace(/^\s*\[|\]\s*$/g,"").split(/[,;]/).map(n=>n.trim()).filter(Boolean);return i.is==="number"||i.is==="integer"?e.map(Dx):e}}),Lx={write:i=>JSON.stringify(i),read:i=>{try{return JSON.parse(i)}catch{throw new Error("Write rows in brackets: [[1, 0], [0, 1]].")}}};function Dx(i){let t=la(i);if(t===void 0)throw new Error(`“${i}” is not a number.`);return t}function Nx(i){return i.is!=="list"?Px:i.of.is==="list"?Lx:Ix(i.of)}var da=class{constructor(t,e,n){this.form=t;this.path=e;let{required:s,default:r,type:o}=n;this.notation=Nx(o),this.row=new Ln(t,e,n),this.element=this.row.element;let a=r===void 0||ca(r)?"":this.notation.write(r);this.input=ot("input",{type:"text",placeholder:s?"needed":a||(o.is==="list"?"none":"left out"),"aria-required":s?"true":void 0,...this.row.control}),this.row.body.append(this.input),Ul(this.input,()=>this.typed(),()=>t.scenario.settle()),this.update()}form;path;element;row;input;notation;shown;update(){this.row.update();let t=this.form.scenario.value(this.path);t!==this.shown&&(this.shown=t,this.input.value=t===void 0?"":this.notation.write(t),this.row.fail(""))}typed(){try{let e=this.input.value.trim()===""?void 0:this.notation.read(this.input.value);this.row.fail(""),this.shown=e,e===void 0?this.form.scenario.remove(this.path):this.form.scenario.set(this.path,e,`type ${yn(this.path)}`),this.shown=this.form.scenario.value(this.path)}catch(t){this.row.fail(t.message)}}};function eo(i,t,e){let{type:n}=e;switch(n.is){case"number":case"integer":return new Ol(i,t,e);case"boolean":return new Ll(i,t,e);case"choice":return new Il(i,t,e,n.of);case"text":return new da(i,t,e);case"file":return new Dl(i,t,e);case"function":return new Nl(i,t,e);case"list":{let{of:s}=n;return s.is==="kind"||s.is==="component"?new io(i,t,e,s):new da(i,t,e)}case"table":return new no(i,t,e,n.of);case"component":return new kl(i,t,e,n);case"kind":return new Xs(i,t,e,n.family);case"any":return new Pl(i,t,e,n.of)}}var Fi=class{element=ot("div",{class:"parameters"});fields;constructor(t,e,n){this.fields=n.map(s=>eo(t,[...e,s.name],s)),this.element.append(...this.fields.map(s=>s.element))}update(){for(let t of this.fields)t.update()}},kl=class{constructor(t,e,n,s){this.form=t;this.path=e;let r=yn(e);this.inner=new Fi(t,e,s.parameters);let o=ot("details",{class:"group","data-group":""},ot("summary",{},ot("span",{class:"name"},n.name),this.mark),ot("p",{class:"about"},...kn(n.doc||s.summary)),ot("p",{class:"error","data-error":r}),this.inner.element);o.open=Ve(t.scenario.value(e)),this.element=o,this.update()}form;path;element;mark=ot("span",{class:"mark",hidden:!0},ot("span",{class:"unseen"},"changed from the preset"));inner;update(){this.mark.hidden=!this.form.scenario.differs(this.path),this.inner.update()}};var io=class{constructor(t,e,n,s){this.form=t;this.path=e;this.item=s;this.row=new Ln(t,e,n,!0);let r=ot("button",{type:"button",class:"add","data-add":yn(e),onclick:()=>this.add()},`Add to ${n.name}`);this.row.body.append(this.list,r),this.element=this.row.element,this.element.removeAttribute("data-words"),this.element.setAttribute("data-group",""),this.update()}form;path;item;element;row;list=ot("ol",{class:"cards"});cards=[];shape="";update(){this.row.update();let{items:t}=this,e=t.map(n=>Ve(n)?String(n.kind??""):"?").join("|");if(e===this.shape&&t.length===this.cards.length){for(let n of this.cards)n.update();return}this.shape=e,this.cards=t.map((n,s)=>this.card(s)),this.list.replaceChildren(...this.cards.map((n,s)=>ot("li",{class:"card"},this.tools(s),n.element)))}get items(){let t=this.form.scenario.value(this.path);return Array.isArray(t)?t:[]}card(t){let e=[...this.path,t];if(this.item.is==="component")return new Fi(this.form,e,this.item.parameters);let n={name:`${this.item.family} ${t+1}`,type:this.item,unit:"",doc:"",range:{},required:!0};return new Xs(this.form,e,n,this.item.family)}tools(t){let e=(n,s,r,o=!1)=>ot("button",{type:"button",class:"tool",disabled:o,"aria-label":`${s} ${t+1}`,onclick:r},n);return ot("div",{class:"tools"},e("↑","Move up",()=>this.move(t,t-1),t===0),e("↓","Move down",()=>this.move(t,t+1),t===this.items.length-1),e("×","Remove",()=>this.remove(t)))}add(){let t=this.item.is==="kind"?{kind:this.form.kinds(this.item.family)[0]?.kind??""}:{};this.form.scenario.set(this.path,[...this.items,t]),this.focus(this.cards.length-1,"select, input")}move(t,e){let n=[...this.items],[s]=n.splice(t,1);s!==void 0&&(n.splice(e,0,s),this.form.scenario.set(this.path,n),this.focus(e,`.tools button:nth-child(${t<e?2:1}):enabled`))}remove(t){this.form.scenario.set(this.path,this.items.filter((e,n)=>n!==t)),this.focus(Math.min(t,this.cards.length-1),".tools button:last-child")}focus(t,e){let n=this.list.children[t];(n?.querySelector(e)??n?.querySelector(".tools button:enabled")??this.element.querySelector(".add"))?.focus()}};var qs="all",Bl=class{constructor(t,e,n){this.form=t;this.path=e;this.family=n;let s=r=>ot("input",{type:"radio",name:`chains-${n}`,onchange:r});this.same=s(()=>this.join()),this.each=s(()=>this.split()),this.element=ot("div",{"data-group":""},ot("fieldset",{class:"segments"},ot("legend",{class:"unseen"},"Chains"),ot("label",{},this.same,ot("span",{},"same for all ports")),ot("label",{},this.each,ot("span",{},"port by port"))),this.lists),this.update()}form;path;family;element;same;each;lists=ot("div",{});fields=[];names="";update(){let t=Object.keys(this.tables),e=t.some(r=>r!==qs),n=this.form.ports.map(({name:r})=>r),s=e?[...new Set([...t,...n])]:[qs];if(this.same.checked=!e,this.each.checked=e,this.each.disabled=n.length===0&&!e,s.join()===this.names){for(let r of this.fields)r.update();return}this.names=s.join(),this.fields=s.map(r=>this.list(r,e)),this.lists.replaceChildren(...this.fields.map(r=>r.element))}list(t,e){let n="Stages between the command and what is delivered, in this order. Without any, the command goes through as it is.",s={is:"kind",family:this.family},r={name:t!==qs?t:e?"all other ports":"all ports",type:{is:"list",of:s},unit:"",doc:n,range:{},required:!1};return new io(this.form,[...this.path,t,"chain"],r,s)}get tables(){let t=this.form.scenario.value(this.path);return Ve(t)?t:{}}chain(t){return this.form.scenario.value([...this.path,t,"chain"])??[]}split(){let t=this.form.ports.map(({name:e})=>e);this.form.scenario.set(this.path,Object.fromEntries(t.map(e=>[e,{chain:this.chain(qs)}])))}join(){let[t]=Object.keys(this.tables);this.form.scenario.set(this.path,{[qs]:{chain:this.chain(qs in this.tables?qs:t??qs)}})}};var bd=(i,t)=>({key:i,title:t,make:e=>{let n={is:"kind",family:i};return new Xs(e,[i],{name:"kind",type:n,unit:"",doc:"",range:{},required:!0},i)}}),Pm=(i,t)=>({key:i,title:t,make:e=>new Bl(e,[i],i)}),zl=(i,t)=>({key:i,title:t,make:e=>new Fi(e,[i],e.schema.tables[i]?.parameters??[])}),Fx={f:"N/m"},Ux={key:"bounds",title:"Bounds",make:i=>{let n={name:"bounds",type:{is:"table",of:{is:"number"}},unit:"N, N m",doc:"what the controller is told of the disturbances: at each port, and along the structure",range:{ge:0},required:!1};return new no(i,["bounds"],n,{is:"number"},Fx)}},Ox=({numerics:i})=>typeof i=="object"&&!Array.isArray(i)&&i.mode==="sampled",Im=[bd("controller","Controller"),Pm("actuator","Actuators"),{...Pm("compensation","Compensation"),onDemand:!0},bd("disturbance","Disturbance"),bd("plant","Plant"),zl("task","Task"),Ux,{...zl("sampling","Sampling"),remark:i=>Ox(i)?"":"Without effect while numerics.mode is not “sampled”."},zl("numerics","Numerics"),zl("output","Output")];var kx=2,Hl=class{constructor(t,e){this.form=e;this.sections=Im.map((n,s)=>new Cl(e,n,s<kx)),this.folds.append(...this.sections.map(n=>n.element)),this.changes=new El(e),this.only=ot("button",{type:"button","aria-pressed":"false",onclick:()=>this.showOnlyChanges(!this.folds.hidden)}),this.search.addEventListener("input",()=>this.sift()),t.replaceChildren(ot("div",{class:"finding"},this.search,this.only),this.found,this.faults,this.changes.element,this.folds),this.update()}form;sections;folds=ot("div",{class:"sections"});filter=new Rl(this.folds);search=ot("input",{type:"search",placeholder:"Find a parameter","aria-label":"Find a parameter",autocomplete:"off"});found=ot("p",{class:"about",role:"status"});faults=ot("ul",{class:"faults","aria-label":"Faults"});changes;only;faulty=!1;told="";update(){for(let e of this.sections)e.update();this.changes.update();let{count:t}=this.changes;On(this.only,t===0?"Changes":`Changes (${t})`),this.search.value&&this.sift()}learn({ports:t,sliders:e}){let n=JSON.stringify([t,e]);n!==this.told&&(this.told=n,this.form.ports=t,this.form.sliders=e,this.update())}show(t){if(t.length===0&&!this.faulty)return;this.faulty=t.length>0;let e=bm(this.folds,t);this.faults.replaceChildren(...e.map(({at:n,text:s})=>ot("li",{},...kn(n?`${n} ${s}`:s)))),t.length>0&&e.length<t.length&&this.showOnlyChanges(!1)}showOnlyChanges(t){this.only.setAttribute("aria-pressed",String(t)),this.folds.hidden=t,this.changes.show(t)}sift(){this.showOnlyChanges(!1);let t=this.filter.apply(this.search.value),e=t===1?"1 parameter":`${t} parameters`;On(this.found,t===null?"":t===0?"No parameter is called so.":e)}};var Bx=500,Vl=class{constructor(t,e){this.changed=e;this.now={preset:t,table:t.table}}changed;now;past=[];future=[];gesture=null;get table(){return this.now.table}get preset(){return this.now.preset}get dirty(){return!Si(this.now.table,this.now.preset.table)}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}value(t){return Qr(this.now.table,t)}differs(t){return!Si(this.value(t),Qr(this.now.preset.table,t))}set(t,e,n=null){Si(this.value(t),e)||this.step({...this.now,table:oa(this.now.table,t,e)},n)}remove(t){this.value(t)!==void 0&&this.step({...this.now,table:ud(this.now.table,t)})}revert(t){let e=Qr(this.now.preset.table,t);e===void 0?this.remove(t):this.set(t,e)}open(t,e=t.table){this.step({preset:t,table:e})}begin(t,e){this.now={preset:t,table:e},this.past=[],this.future=[],this.gesture=null,this.changed()}settle(){this.gesture=null}undo(){this.travel(this.past,this.future)}redo(){this.travel(this.future,this.past)}step(t,e=null){(e===null||e!==this.gesture)&&this.past.push(this.now),this.past.length>Bx&&this.past.shift(),this.gesture=e,this.future=[],this.now=t,this.changed()}travel(t,e){let n=t.pop();n&&(e.push(this.now),this.now=n,this.gesture=null,this.changed())}};var Sd=["system","light","dark"],Lm="dampen-theme",zx=["displacement","rotation","uncontrolled","constraint","learned","ink","faint","paper"],Gl=class{constructor(t){this.changed=t;this.system.addEventListener("change",()=>this.apply()),this.apply()}changed;system=matchMedia("(prefers-color-scheme: dark)");colours=null;get dark(){return this.theme==="system"?this.system.matches:this.theme==="dark"}get theme(){let t=Hx();return Sd.find(e=>e===t)??this.unkept}set theme(t){this.unkept=t,Vx(t),this.apply()}use(t){this.colours=t,this.apply()}unkept="system";apply(){let t=document.documentElement;t.dataset.theme=this.dark?"dark":"light";let e=this.colours?.[this.dark?"dark":"light"];for(let n of zx)e&&t.style.setProperty(`--${n}`,e[n]);this.changed(this.dark)}};function Hx(){try{return localStorage.getItem(Lm)}catch{return null}}function Vx(i){try{localStorage.setItem(Lm,i)}catch{}}var so=class{element;button;panel;constructor(t,...e){this.button=ot("button",{type:"button",class:"unfolds","aria-expanded":"false"},t),this.button.addEventListener("click",()=>this.toggle(this.button.getAttribute("aria-expanded")!=="true")),this.panel=ot("div",{class:"menu",hidden:!0},...e),this.element=ot("div",{class:"holder"},this.button,this.panel),this.element.addEventListener("keydown",n=>{n.key!=="Escape"||this.panel.hidden||(this.toggle(!1),this.button.focus())}),this.panel.addEventListener("click",n=>{n.target.closest("[data-closes]")&&this.toggle(!1)}),document.addEventListener("pointerdown",n=>{this.element.contains(n.target)||this.toggle(!1)}),this.element.addEventListener("focusout",n=>{n.relatedTarget instanceof Node&&!this.element.contains(n.relatedTarget)&&this.toggle(!1)})}toggle(t){this.panel.hidden=!t,this.button.setAttribute("aria-expanded",String(t))}};var Gx=[{what:"toml",label:"Scenario (TOML)"},{what:"netcdf",label:"Result (NetCDF)"},{what:"figures",label:"Figures"},{what:"report",label:"Report"}],Wl=class{presets;other=ot("option",{hidden:!0});undo;redo;pin;swap;unpin;beside;constructor(t,e,n,s){let r=(f,p,x)=>ot("button",{type:"button",onclick:p,title:x},f),o=e.scenarios.map(({name:f,title:p})=>ot("option",{value:f,title:p},f));this.presets=ot("select",{id:"preset","aria-label":"Scenario"},this.other,...o),this.presets.addEventListener("change",()=>n.preset(this.presets.value)),this.undo=r("↶",n.undo,"Undo (Ctrl-Z)"),this.undo.setAttribute("aria-label","Undo"),this.redo=r("↷",n.redo,"Redo (Ctrl-Shift-Z)"),this.redo.setAttribute("aria-label","Redo"),this.pin=r("Pin",n.pin,"Keep this run, and draw it beside what comes"),this.swap=r("Swap",n.swap,"Work on the pinned run, and pin this one"),this.unpin=r("Unpin",n.unpin),this.beside=r("Beside no control",n.beside,"Pin the same experiment without control");let a=ot("input",{type:"file",accept:".toml,.nc",hidden:!0,"aria-label":"Open a scenario or a result"});a.addEventListener("change",()=>{let[f]=a.files??[];f&&n.open(f),a.value=""});let l=(f,p)=>ot("button",{type:"button","data-closes":"",onclick:p},f),c=new so("Download",...Gx.map(({what:f,label:p})=>l(p,()=>n.download(f))),l("Link",n.share)),h=ot("div",{class:"tools-more",id:"tools"},ot("div",{class:"set"},this.pin,this.swap,this.unpin,this.beside),ot("div",{class:"set"},r("Share",n.share,"Copy a link to what you see"),c.element,r("Open…",()=>a.click()),a),Wx(s)),u=ot("button",{type:"button",class:"more","aria-expanded":"false","aria-controls":"tools"},"More"),d=f=>{u.setAttribute("aria-expanded",String(f)),h.classList.toggle("open",f)};u.addEventListener("click",()=>d(u.getAttribute("aria-expanded")!=="true")),document.addEventListener("keydown",f=>f.key==="Escape"&&d(!1)),t.append(this.presets,ot("div",{class:"set"},this.undo,this.redo),u,h)}update({preset:t,dirty:e,canUndo:n,canRedo:s,running:r,pinned:o}){let a=[...this.presets.options].find(l=>l.value===t&&l!==this.other);this.other.hidden=a!==void 0&&!e,this.other.value=a&&!e?"":`${t}*`,this.other.textContent=e?`${t}, changed`:t,this.presets.value=a&&!e?t:this.other.value,this.undo.disabled=!n,this.redo.disabled=!s,this.pin.disabled=!r,this.beside.disabled=!r,this.swap.hidden=this.unpin.hidden=o===null,this.unpin.title=o===null?"":`Let go of: ${o}`}};function Wx(i){let t=Sd.map(n=>ot("option",{value:n},n==="system"?"auto":n)),e=ot("select",{"aria-label":"Colours"},...t);return e.value=i.theme,e.addEventListener("change",()=>i.theme=e.value),e}var Xx=600,Xl=class{sentence=Un("status");banner=Un("banner");warnings=new so("");open=!0;message="";timer=0;constructor(){this.warnings.element.hidden=!0,this.sentence.after(this.warnings.element)}expect(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>this.say("Running."),Xx),this.tell("")}say(t,e=!1){clearTimeout(this.timer),this.sentence.classList.toggle("bad",e),On(this.sentence,t)}picture(t){this.say(qx(t),t.status!=="complete");let{warnings:e}=t;this.warnings.element.hidden=e.length===0,On(this.warnings.button,e.length===1?"1 remark":`${e.length} remarks`),this.warnings.panel.replaceChildren(ot("ul",{},...e.map(n=>ot("li",{},...kn(n)))))}faults([t,...e],n){if(!t)return;let s=e.length===0?"":` And ${e.length} more.`;this.say(Al(`${n}: ${t.at} ${t.text}${s}`.replace(/\s+/g," ")),!0)}tell(t){this.message=t,this.showBanner()}line(t){this.open=t,this.showBanner()}showBanner(){let t=this.open?this.message:"The lab has been closed; start `dampen lab` again.";this.banner.hidden=t==="",On(this.banner,t)}};function qx({status:i,trials:t,asked:e,seconds:n,source:s}){if(i==="diverged")return`The run diverged in trial ${t}, of ${e}.`;let r=`${t} ${t===1?"trial":"trials"}`;if(i==="interrupted")return`Interrupted after ${r} of ${e}.`;let o=s==="file"?`${r}, from a file`:`${r} in ${_m(n)}`;return i==="constraint_lost"?`${o}; the constraint was lost`:o}function Dm(i){let t=new DataView(i).getUint32(0,!0),e=JSON.parse(new TextDecoder().decode(new Uint8Array(i,4,t))),n=4+t,s=r=>{let o=e.arrays[r];if(!o)throw new Error(`The frame has no array ${r}.`);return o};return{header:e,has:r=>r in e.arrays,shape:r=>s(r).shape,array:r=>{let{type:o,shape:a,at:l}=s(r),c=a.reduce((h,u)=>h*u,1);return o==="f4"?new Float32Array(i,n+l,c):new Float64Array(i,n+l,c)}}}var Nm=["now","beside"],Fm=500,Yx=8e3,ql=class{constructor(t,e){this.url=t;this.events=e;this.connect()}url;events;socket=null;retry=Fm;newest=0;unanswered=null;waiting={now:null,beside:null};ask(t,e){let n=++this.newest;return this.waiting[t]={...e,id:n},this.send(),n}get idle(){return this.unanswered===null&&Nm.every(t=>this.waiting[t]===null)}connect(){let t=new WebSocket(this.url);t.binaryType="arraybuffer",t.onopen=()=>{this.socket=t,this.retry=Fm,this.events.open(!0),this.send()},t.onmessage=({data:e})=>this.receive(e),t.onclose=()=>this.lost()}lost(){if(this.socket=null,this.unanswered){let{lane:t,asked:e}=this.unanswered;this.waiting[t]??=e,this.unanswered=null}this.events.open(!1),setTimeout(()=>this.connect(),this.retry),this.retry=Math.min(2*this.retry,Yx)}send(){if(!this.socket||this.unanswered)return;let t=Nm.find(n=>this.waiting[n]!==null),e=t&&this.waiting[t];!t||!e||(this.waiting[t]=null,this.unanswered={lane:t,asked:e},this.socket.send(JSON.stringify(e)))}receive(t){if(typeof t=="string"){let n=JSON.parse(t);(n.say==="refused"||n.say==="failed"||n.say==="left")&&this.answered(n.id),this.events.said(n);return}let e=Dm(t);$x(e)?(this.answered(e.header.id),this.events.picture(e)):this.events.detail(e)}answered(t){this.unanswered?.asked.id===t&&(this.unanswered=null,this.send())}},$x=i=>i.header.say==="picture";var Yl=class{bytes;snapshots;#t;#e;#n=new Map;#s;constructor(t,e){this.#t=t,this.#e=e,this.#s=Float64Array.from({length:e.steps+1},(s,r)=>r*e.step);let n=e.fields[0];this.snapshots=n&&t.has(n.name)?t.shape(n.name)[0]??0:0,this.bytes=Object.entries(t.header.arrays).filter(([s])=>!s.startsWith("all.")).reduce((s,[,{type:r,shape:o}])=>s+o.reduce((a,l)=>a*l,r==="f4"?4:8),0)}column(t,e){let n=`${t}.${e}`,s=this.#n.get(n);if(!s){let r=this.#t.array(t),o=this.#t.shape(t)[1]??1;s=o===1?r:Float32Array.from({length:r.length/o},(a,l)=>r[l*o+e]),this.#n.set(n,s)}return s}curve(t,e){let n=this.column(t,e);return{time:this.#s.subarray(0,n.length),values:n}}at(t,e,n){let s=this.column(t,e),r=Math.min(Math.max(n/this.#e.step,0),s.length-1),o=Math.floor(r),a=Math.min(o+1,s.length-1),l=s[o];return l+(r-o)*(s[a]-l)||l}field(t){return this.#t.array(t)}shape(t,e,n){let s=this.field(t),r=this.snapshots-1,o=Math.min(Math.max(e/this.#e.duration*r,0),r),a=Math.floor(o),l=o-a,c=a*n.length,h=Math.min(a+1,r)*n.length;for(let u=0;u<n.length;u++)n[u]=s[c+u]*(1-l)+s[h+u]*l}};var Zx=48e6,$l=class{picture;peaks;looked=0;#t;#e=new Map;#n=new Map;#s=new Map;#i=null;#o=0;constructor(t){this.#t=t,this.picture=t.header,this.peaks=t.array("peaks"),this.looked=this.picture.trial,t.has("y")&&this.#a(this.picture.trial,t)}get ports(){return this.picture.ports}get x(){return this.#t.has("x")?this.#t.array("x"):new Float32Array(0)}add(t){this.#a(t.header.trial,t),this.#l()}has(t){return this.#e.has(t)}trial(t){return this.#e.get(t)??null}hasSignal(t){return this.#t.has(`all.${t}`)}curve(t,e,n){if(n===null)return{time:this.#r(),values:this.overview(t,e)};let s=this.#e.get(n);if(s)return s.curve(t,e);let r=this.bucketed;return{time:this.#r().subarray(0,r),values:this.overview(t,e).subarray(n*r,(n+1)*r)}}overview(t,e){let n=`${t}.${e}`,s=this.#n.get(n);if(!s){let r=this.#t.array(`all.${t}`),o=this.#t.shape(`all.${t}`)[3]??1;s=new Float32Array(r.length/o);for(let a=0;a<s.length;a++)s[a]=r[a*o+e];this.#n.set(n,s)}return s}get bucketed(){return 2*(this.#t.shape("time")[0]??0)}largest(t,e,n){let s=`${t}.${e}.${n}`,r=this.#s.get(s);if(r===void 0){let o=this.bucketed,a=this.overview(t,e);r=Um(n===null?a:a.subarray(n*o,(n+1)*o)),this.#s.set(s,r)}return r}field(t){let[e=0,n=0]=this.#t.shape(`all.${t}`);return{values:this.#t.array(`all.${t}`),rows:e*n,perTrial:n}}largestOfField(t,e){let n=`field ${t}.${e}`,s=this.#s.get(n);if(s===void 0){let{values:r,perTrial:o}=this.field(t),a=o*this.x.length;s=Um(e===null?r:r.subarray(e*a,(e+1)*a)),this.#s.set(n,s)}return s}peak(t,e){return this.peaks[t*this.ports.length+e]??NaN}#r(){if(!this.#i){let{trials:t,duration:e}=this.picture,n=this.bucketed;this.#i=new Float64Array(t*n);for(let s=0;s<this.#i.length;s++)this.#i[s]=(s+.5)*e/n}return this.#i}#a(t,e){let n=new Yl(e,this.picture);this.#o+=n.bytes-(this.#e.get(t)?.bytes??0),this.#e.set(t,n)}#l(){for(;this.#o>Zx&&this.#e.size>1;){let t=[...this.#e.keys()].reduce((e,n)=>Math.abs(n-this.looked)>Math.abs(e-this.looked)?n:e);this.#o-=this.#e.get(t)?.bytes??0,this.#e.delete(t)}}};function Um(i){let t=0;for(let e=0;e<i.length;e++){let n=Math.abs(i[e]);n>t&&n<1/0&&(t=n)}return t}var Jx=400,Zl=class{constructor(t,e){this.view=t;this.events=e;let n=location.protocol==="https:"?"wss":"ws";this.connection=new ql(`${n}://${location.host}/ws`,{picture:s=>{this.picture(s)},detail:s=>this.detail(s),said:s=>this.said(s),open:s=>this.line(s)})}view;events;now=null;pinned=null;connection;asked=new Map;timer=0;run(t){return this.ask({lane:"now",source:t,missing:null})}runBeside(t){this.ask({lane:"beside",source:t,missing:null})}pin(t){this.pinned=t,this.view.pin(t?.run??null,t?.source.label??""),this.events.pinned(t?.source.label??null),this.soon()}look(t){let{now:e,pinned:n}=this;e&&t<e.run.picture.trials&&!e.run.has(t)&&this.refill("now",e),n&&n!==e&&t<n.run.picture.trials&&!n.run.has(t)&&this.refill("beside",n)}ask(t){let{table:e,token:n}=t.source,{trial:s}=this.view.state,r=n===void 0?{do:"run",table:e,trial:s}:{do:"open",token:n,trial:s},o=this.connection.ask(t.lane,r);return this.asked.set(o,t),this.soon(),o}refill(t,e){e.id=this.ask({lane:t,source:e.source,missing:e}),e.details="coming"}async picture(t){let{id:e}=t.header,n=this.asked.get(e);if(!n)return;if(this.forget(e,n.lane),n.missing){this.add(n.missing.run,Kx(t));return}let s={source:n.source,run:new $l(t),id:e,details:"coming"};if(n.lane==="beside"){this.pin(s);return}this.now=s,this.view.review(null),await this.view.show(s.run),this.now===s&&this.events.drawn(t.header),Jl("dampen:drawn",e)}detail(t){for(let{run:e}of this.showing(t.header.id))this.add(e,t)}add(t,e){t.add(e),this.view.more(t)}said(t){switch(t.say){case"note":this.events.note(t.text);break;case"refused":this.answered(t.id),this.events.refused(t.faults);break;case"failed":this.answered(t.id),this.events.failed(t.text);break;case"review":if(this.now?.id!==t.id)break;this.view.review(t),Jl("dampen:review",t.id);break;case"complete":case"left":for(let e of this.showing(t.id))e.details=t.say;this.soon();break}}answered(t){let e=this.asked.get(t);e&&(e.missing&&(e.missing.details="complete"),this.forget(t,e.lane))}forget(t,e){for(let[n,s]of this.asked)n<=t&&s.lane===e&&this.asked.delete(n)}line(t){for(let e of[this.now,this.pinned])!t&&e?.details==="coming"&&(e.details="left");t&&this.soon(),this.events.line(t)}showing(t){let{now:e,pinned:n}=this;return[e,n===e?null:n].filter(s=>s?.id===t)}soon(){clearTimeout(this.timer),this.timer=window.setTimeout(()=>{let{now:t,pinned:e}=this;this.connection.idle&&(t?.details==="left"?this.refill("now",t):t?.details!=="coming"&&e?.details==="left"&&this.refill("beside",e))},Jx)}};function Kx(i){let{id:t,trial:e,arrays:n}=i.header;return{header:{say:"trial",id:t,trial:e,arrays:n},array:s=>i.array(s),shape:s=>i.shape(s),has:s=>i.has(s)}}var Jl=(i,t)=>window.dispatchEvent(new CustomEvent(i,{detail:{id:t}}));function Om({compensation:i,numerics:t,...e}){let n=Ve(t)?{numerics:{...t,mode:"continuous"}}:{};return{...e,...n,controller:{kind:"none"}}}function Md(i,t,e,n){let s=e*n,r=(i.trial*n+i.time+t)%s,o=Math.min(Math.floor(r/n),e-1);return{trial:o,time:Math.min(Math.max(r-o*n,0),n)}}function km(i,t,e){let n=Math.min(Math.max(Math.floor(i/e),0),t-1);return{trial:n,time:Math.min(Math.max(i-n*e,0),e)}}var jx=["ink","faint","paper","card","line","displacement","rotation","uncontrolled","constraint","learned","reference"],Qx={card:"paper",line:"faint",reference:"ink"},Kl=class{dark=!1;#t=new Map;constructor(){this.read(document.documentElement.dataset.theme==="dark")}read(t){this.dark=t;let e=getComputedStyle(document.documentElement);for(let n of jx)this.#t.set(n,e.getPropertyValue(`--${n}`).trim())}colour(t){return this.#t.get(t)||this.#t.get(Qx[t]??"ink")||"#808080"}},Bm=[[],[7,3],[2,2],[7,2,2,2]],zm=["disc","square","diamond","triangle"];function is(i,t){let e=i[t].motion_unit,n=i.slice(0,t).filter(s=>s.motion_unit===e).length;return{token:e==="m"?"displacement":e==="rad"?"rotation":"ink",dash:Bm[n%Bm.length],marker:zm[t%zm.length]}}function Ys(i){let t=i.motion_unit==="m"?"displacement":i.motion_unit==="rad"?"rotation":"motion";return`${Hm(i)} ${t}`}function $s(i){return`${Hm(i)} ${i.kind}`}function Hm(i){return i.name.replace(/_(w|phi|theta|y)$/,"").replaceAll("_"," ")}function fa(i){return Yn(i.symbol)}function Yn(i){return i.replaceAll("phi","φ").replaceAll("theta","θ")}function Ui(i){return i.charAt(0).toUpperCase()+i.slice(1)}function it(i,{class:t,attributes:e,...n}={},...s){let r=document.createElement(i);t&&(r.className=t);for(let[o,a]of Object.entries(e??{}))r.setAttribute(o,a);return Object.assign(r,n),r.append(...s),r}function rn(i,t){i.textContent!==t&&(i.textContent=t)}function Mi(){return it("div",{class:"figure",attributes:{role:"img"}})}function Qn(i,t){i.getAttribute("aria-label")!==t&&i.setAttribute("aria-label",t)}var tv=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"],[1e-9,"n"]],ev="⁰¹²³⁴⁵⁶⁷⁸⁹";function jl(i){return/^-0(\.0*)?$/.test(i)?i.slice(1):i.replace("-","−")}function wd(i){let t=[...String(Math.abs(i))].map(e=>ev[Number(e)]).join("");return`10${i<0?"⁻":""}${t}`}function Oi(i,t=3){if(!Number.isFinite(i))return Number.isNaN(i)?"–":i>0?"∞":"−∞";if(i===0)return"0";let e=Math.floor(Math.log10(Math.abs(i)));return e<-4||e>5?`${jl((i/10**e).toFixed(Math.max(0,t-1)))} · ${wd(e)}`:jl(i.toFixed(Math.max(0,t-1-e)))}var Je=class{unit;factor;decimals;constructor(t,e){let n=Math.abs(t),s=n>0&&n<1/0&&e!=="",[r,o]=s&&tv.find(([l])=>n>=l*.9995)||[1,""];this.factor=r,this.unit=o+e;let a=n/r;this.decimals=a>0&&a<1/0?Math.min(6,Math.max(0,2-Math.floor(Math.log10(a)))):0}number(t){return Number.isFinite(t)?jl((t/this.factor).toFixed(this.decimals)):Oi(t)}text(t){return`${this.number(t)} ${this.unit}`}};function pa(i,t){return new Je(i,t).text(i)}function Td(i,t){let e=i.length>1?Math.abs(i[1]-i[0])/t:1,n=0;for(;n<8&&Math.abs(e*10**n-Math.round(e*10**n))>1e-6;)n++;return i.map(s=>jl((s/t).toFixed(n)))}function Vm(i){let t=i.map(Gm);return t.filter(Boolean).length<2?i:i.map((e,n)=>t[n]?e:null)}function Gm(i){return Math.abs(Math.log10(i)-Math.round(Math.log10(i)))<1e-9}function Wm(i){let t=i.map(Gm),e=t.filter(Boolean).length<2;return i.map((n,s)=>{if(t[s])return wd(Math.round(Math.log10(n)));let r=Math.round(n/10**Math.floor(Math.log10(n)));return e&&(r===2||r===5)?`${r} · ${wd(Math.floor(Math.log10(n)))}`:""})}var Xm=new Map;function nv(i,t){let e=Xm.get(t);if(e)return e;let n=document.createElement("canvas");n.width=n.height=8;let s=n.getContext("2d");if(!s)return t;s.strokeStyle=t,s.beginPath();for(let o of[-8,0,8])s.moveTo(o,8),s.lineTo(o+8,0);s.stroke();let r=i.createPattern(n,"repeat");return r?(Xm.set(t,r),r):t}function Ed(i,t,e,n){let{ctx:s,bbox:r}=i,o=n>0?r.top:r.top+r.height,a=h=>Math.min(Math.max(h,r.top),r.top+r.height),{time:l,values:c}=e;s.save(),s.beginPath(),s.moveTo(i.valToPos(l[0],"x",!0),o);for(let h=0;h<c.length;h++)(h===0||h===c.length-1||c[h]!==c[h-1]||c[h]!==c[h+1])&&s.lineTo(i.valToPos(l[h],"x",!0),a(i.valToPos(c[h],"y",!0)));s.lineTo(i.valToPos(l[l.length-1],"x",!0),o),s.closePath(),s.fillStyle=t.colour("constraint"),s.globalAlpha=.1,s.fill(),s.fillStyle=nv(s,t.colour("constraint")),s.globalAlpha=.35,s.fill(),s.restore()}function ro(i,t,e,n){let{ctx:s,bbox:r}=i;s.save(),s.strokeStyle=t.colour("faint"),s.globalAlpha=.6,s.lineWidth=devicePixelRatio,s.beginPath();for(let o=1;o<e;o++){let a=Math.round(i.valToPos(o*n,"x",!0));s.moveTo(a,r.top+r.height),s.lineTo(a,r.top+r.height-6*devicePixelRatio)}s.stroke(),s.restore()}var iv="uplot",sv="u-hz",rv="u-vt",ov="u-title",av="u-wrap",lv="u-under",cv="u-over",hv="u-axis",wr="u-off",uv="u-select",dv="u-cursor-x",fv="u-cursor-y",pv="u-cursor-pt",mv="u-legend",gv="u-live",_v="u-inline",yv="u-series",xv="u-marker",qm="u-label",vv="u-value",ga="width",_a="height";var Ym="bottom",oo="left",Ad="right",Wd="#000",$m=Wd+"0",Rd="mousemove",Zm="mousedown",Cd="mouseup",Jm="mouseenter",Km="mouseleave",jm="dblclick",bv="resize",Sv="scroll",Qm="change",ic="dppxchange",Xd="--",po=typeof window<"u",Nd=po?document:null,lo=po?window:null,Mv=po?navigator:null,Me,Ql;function Fd(){let i=devicePixelRatio;Me!=i&&(Me=i,Ql&&Od(Qm,Ql,Fd),Ql=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),Tr(Qm,Ql,Fd),lo.dispatchEvent(new CustomEvent(ic)))}function hi(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Ud(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Ge(i,t,e){i.style[t]=e+"px"}function ki(i,t,e,n){let s=Nd.createElement(i);return t!=null&&hi(s,t),e?.insertBefore(s,n),s}function wi(i,t){return ki("div",i,t)}var tg=new WeakMap;function ss(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=tg.get(i);r!=o&&(i.style.transform=r,tg.set(i,r),t<0||e<0||t>n||e>s?hi(i,wr):Ud(i,wr))}var eg=new WeakMap;function ng(i,t,e){let n=t+e,s=eg.get(i);n!=s&&(eg.set(i,n),i.style.background=t,i.style.borderColor=e)}var ig=new WeakMap;function sg(i,t,e,n){let s=t+""+e,r=ig.get(i);s!=r&&(ig.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}var qd={passive:!0},wv={...qd,capture:!0};function Tr(i,t,e,n){t.addEventListener(i,e,n?wv:qd)}function Od(i,t,e,n){t.removeEventListener(i,e,qd)}po&&Fd();function Bi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:ui((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Lg(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}var Dg=i=>i!=null,Ng=i=>i!=null&&i>0,oc=Lg(Dg),Tv=Lg(Ng);function Ev(i,t,e,n=0,s=!1){let r=s?Tv:oc,o=s?Ng:Dg;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let h=i[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??De,l??-De]}function ac(i,t,e,n){let s=ag(i),r=ag(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?bs:Fg,a=s==1?ui:Ti,l=r==1?Ti:ui,c=a(o(vn(i))),h=l(o(vn(t))),u=co(e,c),d=co(e,h);return e==10&&(c<0&&(u=Ne(u,-c)),h<0&&(d=Ne(d,-h))),n||e==2?(i=u*s,t=d*r):(i=Bg(i,u),t=lc(t,d)),[i,t]}function Yd(i,t,e,n){let s=ac(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}var $d=.1,rg={mode:3,pad:$d},xa={pad:0,soft:null,mode:0},Av={min:xa,max:xa};function sc(i,t,e,n){return cc(e)?og(i,t,e):(xa.pad=e,xa.soft=n?0:null,xa.mode=n?3:0,og(i,t,Av))}function be(i,t){return i??t}function Rv(i,t,e){for(t=be(t,0),e=be(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function og(i,t,e){let n=e.min,s=e.max,r=be(n.pad,0),o=be(s.pad,0),a=be(n.hard,-De),l=be(s.hard,De),c=be(n.soft,De),h=be(s.soft,-De),u=be(n.mode,0),d=be(s.mode,0),f=t-i,p=bs(f),x=$n(vn(i),vn(t)),g=bs(x),m=vn(g-p);(f<1e-24||m>10)&&(f=0,(i==0||t==0)&&(f=1e-24,u==2&&c!=De&&(r=0),d==2&&h!=-De&&(o=0)));let v=f||x||1e3,A=bs(v),S=co(10,ui(A)),C=v*(f==0?i==0?.1:1:r),E=Ne(Bg(i-C,S/10),24),_=i>=c&&(u==1||u==3&&E<=c||u==2&&E>=c)?c:De,T=$n(a,E<_&&i>=_?_:zi(_,E)),O=v*(f==0?t==0?.1:1:o),N=Ne(lc(t+O,S/10),24),D=t<=h&&(d==1||d==3&&N>=h||d==2&&N<=h)?h:-De,z=zi(l,N>D&&t<=D?D:$n(D,N));return T==z&&T==0&&(z=100),[T,z]}var Cv=new Intl.NumberFormat(po?Mv.language:"en-US"),Zd=i=>Cv.format(i),di=Math,nc=di.PI,vn=di.abs,ui=di.floor,xn=di.round,Ti=di.ceil,zi=di.min,$n=di.max,co=di.pow,ag=di.sign,bs=di.log10,Fg=di.log2,Pv=(i,t=1)=>di.sinh(i)*t,Pd=(i,t=1)=>di.asinh(i/t),De=1/0;function lg(i){return(bs((i^i>>31)-(i>>31))|0)+1}function kd(i,t,e){return zi($n(i,t),e)}function Ug(i){return typeof i=="function"}function _e(i){return Ug(i)?i:()=>i}var Iv=()=>{},Og=i=>i,kg=(i,t)=>t,Lv=i=>null,cg=i=>!0,hg=(i,t)=>i==t,Dv=/\.\d*?(?=9{6,}|0{6,})/gm,Er=i=>{if(Hg(i)||Js.has(i))return i;let t=`${i}`,e=t.match(Dv);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Er(s)}e${r}`}return Ne(i,n)};function Sr(i,t){return Er(Ne(Er(i/t))*t)}function lc(i,t){return Er(Ti(Er(i/t))*t)}function Bg(i,t){return Er(ui(Er(i/t))*t)}function Ne(i,t=0){if(Hg(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return xn(n)/e}var Js=new Map;function zg(i){return((""+i).split(".")[1]||"").length}function ba(i,t,e,n){let s=[],r=n.map(zg);for(let o=t;o<e;o++){let a=vn(o),l=Ne(co(i,o),a);for(let c=0;c<n.length;c++){let h=i==10?+`${n[c]}e${o}`:n[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?h:Ne(h,u);s.push(d),Js.set(d,u)}}return s}var va={},Jd=[],ho=[null,null],Zs=Array.isArray,Hg=Number.isInteger,Nv=i=>i===void 0;function ug(i){return typeof i=="string"}function cc(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Fv(i){return i!=null&&typeof i=="object"}var Uv=Object.getPrototypeOf(Uint8Array),Vg="__proto__";function uo(i,t=cc){let e;if(Zs(i)){let n=i.find(s=>s!=null);if(Zs(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=uo(i[s],t)}else e=i.slice()}else if(i instanceof Uv)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Vg&&(e[n]=uo(i[n],t))}else e=i;return e}function pn(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Vg&&(cc(i[s])?pn(i[s],uo(n[s])):i[s]=uo(n[s]))}return i}var Ov=0,kv=1,Bv=2;function zv(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Hv(i,t){if(Wv(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return Xv(o[0])||(o=Gv(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:kv,f=[];for(let p=0;p<h.length;p++){let x=h[p],g=r.get(l[p]);x===null?d!=Ov&&(u[g]=x,d==Bv&&f.push(g)):u[g]=x}zv(u,f,s),n.push(u)}}return n}var Vv=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function Gv(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function Wv(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Xv(i,t=100){let e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=$n(1,ui((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Gg=["January","February","March","April","May","June","July","August","September","October","November","December"],Wg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Xg(i){return i.slice(0,3)}var qv=Wg.map(Xg),Yv=Gg.map(Xg),$v={MMMM:Gg,MMM:Yv,WWWW:Wg,WWW:qv};function ma(i){return(i<10?"0":"")+i}function Zv(i){return(i<10?"00":i<100?"0":"")+i}var Jv={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>ma(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ma(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>ma(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ma(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ma(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Zv(i.getMilliseconds())};function Kd(i,t){t=t||$v;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?Jv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var Kv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function jv(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==Kv?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}var qg=i=>i%1==0,rc=[1,2,2.5,5],Qv=ba(10,-32,0,rc),Yg=ba(10,0,32,rc),tb=Yg.filter(qg),Mr=Qv.concat(Yg),jd=`
`,$g="{YYYY}",dg=jd+$g,Zg="{M}/{D}",ya=jd+Zg,tc=ya+"/{YY}",Jg="{aa}",eb="{h}:{mm}",ao=eb+Jg,fg=jd+ao,pg=":{ss}",Te=null;function Kg(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?ba(10,0,3,rc).filter(qg):ba(10,-3,0,rc)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,$g,Te,Te,Te,Te,Te,Te,1],[s*28,"{MMM}",dg,Te,Te,Te,Te,Te,1],[s,Zg,dg,Te,Te,Te,Te,Te,1],[n,"{h}"+Jg,tc,Te,ya,Te,Te,Te,1],[e,ao,tc,Te,ya,Te,Te,Te,1],[t,pg,tc+" "+ao,Te,ya+" "+ao,Te,fg,Te,1],[i,pg+".{fff}",tc+" "+ao,Te,ya+" "+ao,Te,fg,Te,1]];function h(u){return(d,f,p,x,g,m)=>{let v=[],A=g>=o,S=g>=r&&g<o,C=u(p),E=Ne(C*i,3),_=Id(C.getFullYear(),A?0:C.getMonth(),S||A?1:C.getDate()),T=Ne(_*i,3);if(S||A){let O=S?g/r:0,N=A?g/o:0,D=E==T?E:Ne(Id(_.getFullYear()+N,_.getMonth()+O,1)*i,3),z=new Date(xn(D/i)),G=z.getFullYear(),L=z.getMonth();for(let W=0;D<=x;W++){let Y=Id(G+N*W,L+O*W,1),V=Y-u(Ne(Y*i,3));D=Ne((+Y+V)*i,3),D<=x&&v.push(D)}}else{let O=g>=s?s:g,N=ui(p)-ui(E),D=T+N+lc(E-T,O);v.push(D);let z=u(D),G=z.getHours()+z.getMinutes()/e+z.getSeconds()/n,L=g/n,W=d.axes[f]._space,Y=m/W;for(;D=Ne(D+g,i==1?0:3),!(D>x);)if(L>1){let V=ui(Ne(G+L,6))%24,j=u(D).getHours()-V;j>1&&(j=-1),D-=j*n,G=(G+L)%24;let st=v[v.length-1];Ne((D-st)/g,3)*Y>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,h]}var[nb,ib,sb]=Kg(1),[rb,ob,ab]=Kg(.001);ba(2,-53,53,[1]);function mg(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function gg(i,t){return(e,n,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,d,f;return n.map(p=>{let x=i(p),g=x.getFullYear(),m=x.getMonth(),v=x.getDate(),A=x.getHours(),S=x.getMinutes(),C=x.getSeconds(),E=g!=l&&a[2]||m!=c&&a[3]||v!=h&&a[4]||A!=u&&a[5]||S!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=m,h=v,u=A,d=S,f=C,E(x)})}}function lb(i,t){let e=Kd(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Id(i,t,e){return new Date(i,t,e)}function _g(i,t){return t(i)}var cb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function yg(i,t){return(e,n,s,r)=>r==null?Xd:t(i(n))}function hb(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function ub(i,t){return i.series[t].fill(i,t)}var db={show:!0,live:!0,isolate:!1,mount:Iv,markers:{show:!0,width:2,stroke:hb,fill:ub,dash:"solid"},idx:null,idxs:null,values:[]};function fb(i,t){let e=i.cursor.points,n=wi(),s=e.size(i,t);Ge(n,ga,s),Ge(n,_a,s);let r=s/-2;Ge(n,"marginLeft",r),Ge(n,"marginTop",r);let o=e.width(i,t,s);return o&&Ge(n,"borderWidth",o),n}function pb(i,t){let e=i.series[t].points;return e._fill||e._stroke}function mb(i,t){let e=i.series[t].points;return e._stroke||e._fill}function gb(i,t){return i.series[t].points.size}var Ld=[0,0];function _b(i,t,e){return Ld[0]=t,Ld[1]=e,Ld}function ec(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function Dd(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}var yb={show:!0,x:!0,y:!0,lock:!1,move:_b,points:{one:!1,show:fb,size:gb,width:0,stroke:mb,fill:pb},bind:{mousedown:ec,mouseup:ec,click:ec,dblclick:ec,mousemove:Dd,mouseleave:Dd,mouseenter:Dd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},jg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Qd=pn({},jg,{filter:kg}),Qg=pn({},Qd,{size:10}),t0=pn({},jg,{show:!1}),tf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',e0="bold "+tf,n0=1.5,xg={show:!0,scale:"x",stroke:Wd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:e0,side:2,grid:Qd,ticks:Qg,border:t0,font:tf,lineGap:n0,rotate:0},xb="Value",vb="Time",vg={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function bb(i,t,e,n,s){return t.map(r=>r==null?"":Zd(r))}function Sb(i,t,e,n,s,r,o){let a=[],l=Js.get(s)||0;e=o?e:Ne(lc(e,s),l);for(let c=e;c<=n;c=Ne(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Bd(i,t,e,n,s,r,o){let a=[],l=i.scales[i.axes[t].scale].log,c=l==10?bs:Fg,h=ui(c(e));s=co(l,h),l==10&&(s=Mr[Bi(s,Mr)]);let u=e,d=s*l;l==10&&(d=Mr[Bi(d,Mr)]);do a.push(u),u=u+s,l==10&&!Js.has(u)&&(u=Ne(u,Js.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Mr[Bi(d,Mr)]));while(u<=n);return a}function Mb(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?Bd(i,t,$n(l,e),n,s):[l],h=n>=0&&e<=0?[0]:[];return(e<-l?Bd(i,t,$n(l,-n),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var i0=/./,wb=/[12357]/,Tb=/[125]/,bg=/1/,zd=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Eb(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?i0:l(7,o)-h>=c?wb:l(5,o)-h>=c?Tb:bg;if(u==bg){let d=vn(l(1,o)-h);if(d<c)return zd(t.slice().reverse(),a.distr,u,Ti(c/d)).reverse()}return zd(t,a.distr,u,1)}function Ab(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=vn(l(1,o)-l(2,o));return c<a?zd(t.slice().reverse(),3,i0,Ti(a/c)).reverse():t}function Rb(i,t,e,n){return n==null?Xd:t==null?"":Zd(t)}var Sg={show:!0,scale:"y",stroke:Wd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:e0,side:3,grid:Qd,ticks:Qg,border:t0,font:tf,lineGap:n0,rotate:0};function Cb(i,t){let e=3+(i||1)*2;return Ne(e*t,3)}function Pb(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=vn(o-r),l=i.series[t],c=a/(l.points.space*Me);return n[1]-n[0]<=c}var Mg={scale:null,auto:!0,sorted:0,min:De,max:-De},s0=(i,t,e,n,s)=>s,wg={show:!0,auto:!0,sorted:0,gaps:s0,alpha:1,facets:[pn({},Mg,{scale:"x"}),pn({},Mg,{scale:"y"})]},Tg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:s0,alpha:1,points:{show:Pb,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function Ib(i,t,e,n,s){return e/10}var r0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Lb=pn({},r0,{time:!1,ori:1}),Eg={};function o0(i,t){let e=Eg[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(n,s,r,o,a,l,c)}},i!=null&&(Eg[i]=e)),e}var fo=1,Hd=2;function Ar(i,t,e){let n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[t],h=n==2?o[s.facets[0].scale]:o[i.series[0].scale],u=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,g=i.valToPosH,m=i.valToPosV;return h.ori==0?e(s,l,c,h,u,g,m,d,f,p,x,uc,mo,fc,l0,h0):e(s,l,c,h,u,m,g,f,d,x,p,dc,go,sf,c0,u0)}function ef(i,t){let e=0,n=0,s=be(i.bands,Jd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Db(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ss(i,t,e,n,s,r){return Ar(i,t,(o,a,l,c,h,u,d,f,p,x,g)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),A=c.ori==0?mo:go,S,C;v==1?(S=e,C=n):(S=n,C=e);let E=m(u(a[S],c,x,f)),_=m(d(l[S],h,g,p)),T=m(u(a[C],c,x,f)),O=m(d(r==1?h.max:h.min,h,g,p)),N=new Path2D(s);return A(N,T,O),A(N,E,O),A(N,E,_),N})}function hc(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=t==0?fc:sf,l=e;for(let u=0;u<i.length;u++){let d=i[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,n-h/2,c,n+r+h)}return o}function Nb(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function nf(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=n&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(i[u]),p=d==u?f:r(i[d]),x=u-s;f=o<=0&&x>=0&&x<l?r(i[x]):f;let m=d+s;p=o>=0&&m>=0&&m<l?r(i[m]):p,p>=f&&a.push([f,p])}return a}function Ag(i){return i==0?Og:i==1?xn:t=>Sr(t,i)}function a0(i){let t=i==0?uc:dc,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?n(s,r,o,a,l):(c=zi(c,a/2,l/2),h=zi(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var uc=(i,t,e)=>{i.moveTo(t,e)},dc=(i,t,e)=>{i.moveTo(e,t)},mo=(i,t,e)=>{i.lineTo(t,e)},go=(i,t,e)=>{i.lineTo(e,t)},fc=a0(0),sf=a0(1),l0=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},c0=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},h0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},u0=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function d0(i){return(t,e,n,s,r)=>Ar(t,e,(o,a,l,c,h,u,d,f,p,x,g)=>{let{pxRound:m,points:v}=o,A,S;c.ori==0?(A=uc,S=l0):(A=dc,S=c0);let C=Ne(v.width*Me,3),E=(v.size-v.width)/2*Me,_=Ne(E*2,3),T=new Path2D,O=new Path2D,{left:N,top:D,width:z,height:G}=t.bbox;fc(O,N-_,D-_,z+_*2,G+_*2);let L=W=>{if(l[W]!=null){let Y=m(u(a[W],c,x,f)),V=m(d(l[W],h,g,p));A(T,Y+E,V),S(T,Y,V,E,0,nc*2)}};if(r)r.forEach(L);else for(let W=n;W<=s;W++)L(W);return{stroke:C>0?T:null,fill:T,clip:O,flags:fo|Hd}})}function f0(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}var Fb=f0(mo),Ub=f0(go);function p0(i){let t=be(i?.alignGaps,0);return(e,n,s,r)=>Ar(e,n,(o,a,l,c,h,u,d,f,p,x,g)=>{[s,r]=oc(l,s,r);let m=o.pxRound,v=G=>m(u(G,c,x,f)),A=G=>m(d(G,h,g,p)),S,C;c.ori==0?(S=mo,C=Fb):(S=go,C=Ub);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},T=_.stroke,O=!1;if(r-s>=x*4){let G=dt=>e.posToVal(dt,c.key,!0),L=null,W=null,Y,V,ht,J=v(a[E==1?s:r]),j=v(a[s]),st=v(a[r]),ft=G(E==1?j+1:st-1);for(let dt=E==1?s:r;dt>=s&&dt<=r;dt+=E){let Q=a[dt],xt=(E==1?Q<ft:Q>ft)?J:v(Q),Rt=l[dt];xt==J?Rt!=null?(V=Rt,L==null?(S(T,xt,A(V)),Y=L=W=V):V<L?L=V:V>W&&(W=V)):Rt===null&&(O=!0):(L!=null&&C(T,J,A(L),A(W),A(Y),A(V)),Rt!=null?(V=Rt,S(T,xt,A(V)),L=W=Y=V):(L=W=null,Rt===null&&(O=!0)),J=xt,ft=G(J+E))}L!=null&&L!=W&&ht!=J&&C(T,J,A(L),A(W),A(Y),A(V))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let L=l[G];L===null?O=!0:L!=null&&S(T,v(a[G]),A(L))}let[D,z]=ef(e,n);if(o.fill!=null||D!=0){let G=_.fill=new Path2D(T),L=o.fillTo(e,n,o.min,o.max,D),W=A(L),Y=v(a[s]),V=v(a[r]);E==-1&&([V,Y]=[Y,V]),S(G,V,W),S(G,Y,W)}if(!o.spanGaps){let G=[];O&&G.push(...nf(a,l,s,r,E,v,t)),_.gaps=G=o.gaps(e,n,s,r,G),_.clip=hc(G,c.ori,f,p,x,g)}return z!=0&&(_.band=z==2?[Ss(e,n,s,r,T,-1),Ss(e,n,s,r,T,1)]:Ss(e,n,s,r,T,z)),_})}function Ob(i){let t=be(i.align,1),e=be(i.ascDesc,!1),n=be(i.alignGaps,0),s=be(i.extend,!1);return(r,o,a,l)=>Ar(r,o,(c,h,u,d,f,p,x,g,m,v,A)=>{[a,l]=oc(u,a,l);let S=c.pxRound,{left:C,width:E}=r.bbox,_=j=>S(p(j,d,v,g)),T=j=>S(x(j,f,A,m)),O=d.ori==0?mo:go,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:fo},D=N.stroke,z=d.dir*(d.ori==0?1:-1),G=T(u[z==1?a:l]),L=_(h[z==1?a:l]),W=L,Y=L;s&&t==-1&&(Y=C,O(D,Y,G)),O(D,L,G);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let st=u[j];if(st==null)continue;let ft=_(h[j]),dt=T(st);t==1?O(D,ft,G):O(D,W,dt),O(D,ft,dt),G=dt,W=ft}let V=W;s&&t==1&&(V=C+E,O(D,V,G));let[ht,J]=ef(r,o);if(c.fill!=null||ht!=0){let j=N.fill=new Path2D(D),st=c.fillTo(r,o,c.min,c.max,ht),ft=T(st);O(j,V,ft),O(j,Y,ft)}if(!c.spanGaps){let j=[];j.push(...nf(h,u,a,l,z,_,n));let st=c.width*Me/2,ft=e||t==1?st:-st,dt=e||t==-1?-st:st;j.forEach(Q=>{Q[0]+=ft,Q[1]+=dt}),N.gaps=j=c.gaps(r,o,a,l,j),N.clip=hc(j,d.ori,g,m,v,A)}return J!=0&&(N.band=J==2?[Ss(r,o,a,l,D,-1),Ss(r,o,a,l,D,1)]:Ss(r,o,a,l,D,J)),N})}function Rg(i,t,e,n,s,r,o=De){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let h=vn(i[l]-i[a]);h<c&&(c=h,o=vn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function kb(i){i=i||va;let t=be(i.size,[.6,De,1]),e=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_e(s),o=1-t[0],a=be(t[1],De),l=be(t[2],1),c=be(i.disp,va),h=be(i.each,f=>{}),{fill:u,stroke:d}=c;return(f,p,x,g)=>Ar(f,p,(m,v,A,S,C,E,_,T,O,N,D)=>{let z=m.pxRound,G=e,L=n*Me,W=a*Me,Y=l*Me,V,ht;S.ori==0?[V,ht]=r(f,p):[ht,V]=r(f,p);let J=S.dir*(S.ori==0?1:-1),j=S.ori==0?fc:sf,st=S.ori==0?h:(Pt,Zt,re,wt,Le,Vt,Yt)=>{h(Pt,Zt,re,Le,wt,Yt,Vt)},ft=be(f.bands,Jd).find(Pt=>Pt.series[0]==p),dt=ft!=null?ft.dir:0,Q=m.fillTo(f,p,m.min,m.max,dt),gt=z(_(Q,C,D,O)),xt,Rt,Mt,Xt=N,se=z(m.width*Me),Gt=!1,de=null,ae=null,ne=null,qe=null;u!=null&&(se==0||d!=null)&&(Gt=!0,de=u.values(f,p,x,g),ae=new Map,new Set(de).forEach(Pt=>{Pt!=null&&ae.set(Pt,new Path2D)}),se>0&&(ne=d.values(f,p,x,g),qe=new Map,new Set(ne).forEach(Pt=>{Pt!=null&&qe.set(Pt,new Path2D)})));let{x0:Fe,size:ln}=c;if(Fe!=null&&ln!=null){G=1,v=Fe.values(f,p,x,g),Fe.unit==2&&(v=v.map(re=>f.posToVal(T+re*N,S.key,!0)));let Pt=ln.values(f,p,x,g);ln.unit==2?Rt=Pt[0]*N:Rt=E(Pt[0],S,N,T)-E(0,S,N,T),Xt=Rg(v,A,E,S,N,T,Xt),Mt=Xt-Rt+L}else Xt=Rg(v,A,E,S,N,T,Xt),Mt=Xt*o+L,Rt=Xt-Mt;Mt<1&&(Mt=0),se>=Rt/2&&(se=0),Mt<5&&(z=Og);let Pe=Mt>0,wn=Xt-Mt-(Pe?se:0);Rt=z(kd(wn,Y,W)),xt=(G==0?Rt/2:G==J?0:Rt)-G*J*((G==0?L/2:0)+(Pe?se/2:0));let xe={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},gn=Gt?null:new Path2D,Qe=null;if(ft!=null)Qe=f.data[ft.series[1]];else{let{y0:Pt,y1:Zt}=c;Pt!=null&&Zt!=null&&(A=Zt.values(f,p,x,g),Qe=Pt.values(f,p,x,g))}let cn=V*Rt,U=ht*Rt;for(let Pt=J==1?x:g;Pt>=x&&Pt<=g;Pt+=J){let Zt=A[Pt];if(Zt==null)continue;if(Qe!=null){let X=Qe[Pt]??0;if(Zt-X==0)continue;gt=_(X,C,D,O)}let re=S.distr!=2||c!=null?v[Pt]:Pt,wt=E(re,S,N,T),Le=_(be(Zt,Q),C,D,O),Vt=z(wt-xt),Yt=z($n(Le,gt)),R=z(zi(Le,gt)),b=Yt-R;if(Zt!=null){let X=Zt<0?U:cn,ut=Zt<0?cn:U;Gt?(se>0&&ne[Pt]!=null&&j(qe.get(ne[Pt]),Vt,R+ui(se/2),Rt,$n(0,b-se),X,ut),de[Pt]!=null&&j(ae.get(de[Pt]),Vt,R+ui(se/2),Rt,$n(0,b-se),X,ut)):j(gn,Vt,R+ui(se/2),Rt,$n(0,b-se),X,ut),st(f,p,Pt,Vt-se/2,R,Rt+se,b)}}return se>0?xe.stroke=Gt?qe:gn:Gt||(xe._fill=m.width==0?m._fill:m._stroke??m._fill,xe.width=0),xe.fill=Gt?ae:gn,xe})}function Bb(i,t){let e=be(t?.alignGaps,0);return(n,s,r,o)=>Ar(n,s,(a,l,c,h,u,d,f,p,x,g,m)=>{[r,o]=oc(c,r,o);let v=a.pxRound,A=V=>v(d(V,h,g,p)),S=V=>v(f(V,u,m,x)),C,E,_;h.ori==0?(C=uc,_=mo,E=h0):(C=dc,_=go,E=u0);let T=h.dir*(h.ori==0?1:-1),O=A(l[T==1?r:o]),N=O,D=[],z=[];for(let V=T==1?r:o;V>=r&&V<=o;V+=T)if(c[V]!=null){let J=l[V],j=A(J);D.push(N=j),z.push(S(c[V]))}let G={stroke:i(D,z,C,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:fo},L=G.stroke,[W,Y]=ef(n,s);if(a.fill!=null||W!=0){let V=G.fill=new Path2D(L),ht=a.fillTo(n,s,a.min,a.max,W),J=S(ht);_(V,N,J),_(V,O,J)}if(!a.spanGaps){let V=[];V.push(...nf(l,c,r,o,T,A,e)),G.gaps=V=a.gaps(n,s,r,o,V),G.clip=hc(V,h.ori,p,x,g,m)}return Y!=0&&(G.band=Y==2?[Ss(n,s,r,o,L,-1),Ss(n,s,r,o,L,1)]:Ss(n,s,r,o,L,Y)),G})}function zb(i){return Bb(Hb,i)}function Hb(i,t,e,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=i[d+1]-i[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+u[d]/3,t[d]+l[d]*u[d]/3,i[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,i[d+1],t[d+1])}return a}var Vd=new Set;function Cg(){for(let i of Vd)i.syncRect(!0)}po&&(Tr(bv,lo,Cg),Tr(Sv,lo,Cg,!0),Tr(ic,lo,()=>{Dn.pxRatio=Me}));var Vb=p0(),Gb=d0();function Pg(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Gd(r,o,t,e))}function Wb(i,t){return i.map((e,n)=>n==0?{}:pn({},t,e))}function Gd(i,t,e,n){return pn({},t==0?e:n,i)}function m0(i,t,e){return t==null?ho:[t,e]}var Xb=m0;function qb(i,t,e){return t==null?ho:sc(t,e,$d,!0)}function g0(i,t,e,n){return t==null?ho:ac(t,e,i.scales[n].log,!1)}var Yb=g0;function _0(i,t,e,n){return t==null?ho:Yd(t,e,i.scales[n].log,!1)}var $b=_0;function Zb(i,t,e,n,s){let r=$n(lg(i),lg(t)),o=t-i,a=Bi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?Js.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ig(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=xn((e=+s)*Me))+"px"),[i,t,e]}function Jb(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Ne(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Dn(i,t,e){let n={mode:be(i.mode,1)},s=n.mode;function r(y,M,P,I){let H=M.valToPct(y);return I+P*(M.dir==-1?1-H:H)}function o(y,M,P,I){let H=M.valToPct(y);return I+P*(M.dir==-1?H:1-H)}function a(y,M,P,I){return M.ori==0?r(y,M,P,I):o(y,M,P,I)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=wi(iv);if(i.id!=null&&(c.id=i.id),hi(c,i.class),i.title){let y=wi(ov,c);y.textContent=i.title}let h=ki("canvas"),u=n.ctx=h.getContext("2d"),d=wi(av,c);Tr("click",d,y=>{y.target===p&&(Be!=$r||Ye!=Zr)&&In.click(n,y)},!0);let f=n.under=wi(lv,d);d.appendChild(h);let p=n.over=wi(cv,d);i=uo(i);let x=+be(i.pxAlign,1),g=Ag(x);(i.plugins||[]).forEach(y=>{y.opts&&(i=y.opts(n,i)||i)});let m=i.ms||.001,v=n.series=s==1?Pg(i.series||[],vg,Tg,!1):Wb(i.series||[null],wg),A=n.axes=Pg(i.axes||[],xg,Sg,!0),S=n.scales={},C=n.bands=i.bands||[];C.forEach(y=>{y.fill=_e(y.fill||null),y.dir=be(y.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:ys,series:pe},T=(i.drawOrder||["axes","series"]).map(y=>_[y]);function O(y){let M=y.distr==3?P=>bs(P>0?P:y.clamp(n,P,y.min,y.max,y.key)):y.distr==4?P=>Pd(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let I=M(P),{_min:H,_max:Z}=y,lt=Z-H;return(I-H)/lt}}function N(y){let M=S[y];if(M==null){let P=(i.scales||va)[y]||va;if(P.from!=null){N(P.from);let I=pn({},S[P.from],P,{key:y});I.valToPct=O(I),S[y]=I}else{M=S[y]=pn({},y==E?r0:Lb,P),M.key=y;let I=M.time,H=M.range,Z=Zs(H);if((y!=E||s==2&&!I)&&(Z&&(H[0]==null||H[1]==null)&&(H={min:H[0]==null?rg:{mode:1,hard:H[0],soft:H[0]},max:H[1]==null?rg:{mode:1,hard:H[1],soft:H[1]}},Z=!1),!Z&&cc(H))){let lt=H;H=(pt,bt,Nt)=>bt==null?ho:sc(bt,Nt,lt)}M.range=_e(H||(I?Xb:y==E?M.distr==3?Yb:M.distr==4?$b:m0:M.distr==3?g0:M.distr==4?_0:qb)),M.auto=_e(Z?!1:M.auto),M.clamp=_e(M.clamp||Ib),M._min=M._max=null,M.valToPct=O(M)}}}N("x"),N("y"),s==1&&v.forEach(y=>{N(y.scale)}),A.forEach(y=>{N(y.scale)});for(let y in i.scales)N(y);let D=S[E],z=D.distr,G,L;D.ori==0?(hi(c,sv),G=r,L=o):(hi(c,rv),G=o,L=r);let W={};for(let y in S){let M=S[y];(M.min!=null||M.max!=null)&&(W[y]={min:M.min,max:M.max},M.min=M.max=null)}let Y=i.tzDate||(y=>new Date(xn(y/m))),V=i.fmtDate||Kd,ht=m==1?sb(Y):ab(Y),J=gg(Y,mg(m==1?ib:ob,V)),j=yg(Y,_g(cb,V)),st=[],ft=n.legend=pn({},db,i.legend),dt=n.cursor=pn({},yb,{drag:{y:s==2}},i.cursor),Q=ft.show,gt=dt.show,xt=ft.markers;ft.idxs=st,xt.width=_e(xt.width),xt.dash=_e(xt.dash),xt.stroke=_e(xt.stroke),xt.fill=_e(xt.fill);let Rt,Mt,Xt,se=[],Gt=[],de,ae=!1,ne={};if(ft.live){let y=v[1]?v[1].values:null;ae=y!=null,de=ae?y(n,1,0):{_:0};for(let M in de)ne[M]=Xd}if(Q)if(Rt=ki("table",mv,c),Xt=ki("tbody",null,Rt),ft.mount(n,Rt),ae){Mt=ki("thead",null,Rt,Xt);let y=ki("tr",null,Mt);ki("th",null,y);for(var qe in de)ki("th",qm,y).textContent=qe}else hi(Rt,_v),ft.live&&hi(Rt,gv);let Fe={show:!0},ln={show:!1};function Pe(y,M){if(M==0&&(ae||!ft.live||s==2))return ho;let P=[],I=ki("tr",yv,Xt,Xt.childNodes[M]);hi(I,y.class),y.show||hi(I,wr);let H=ki("th",null,I);if(xt.show){let pt=wi(xv,H);if(M>0){let bt=xt.width(n,M);bt&&(pt.style.border=bt+"px "+xt.dash(n,M)+" "+xt.stroke(n,M)),pt.style.background=xt.fill(n,M)}}let Z=wi(qm,H);y.label instanceof HTMLElement?Z.appendChild(y.label):Z.textContent=y.label,M>0&&(xt.show||(Z.style.color=y.width>0?xt.stroke(n,M):xt.fill(n,M)),xe("click",H,pt=>{if(dt._lock)return;Kt(pt);let bt=v.indexOf(y);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=v.some((Ft,Ot)=>Ot>0&&Ot!=bt&&Ft.show);v.forEach((Ft,Ot)=>{Ot>0&&Qi(Ot,Nt?Ot==bt?Fe:ln:Fe,!0,fn.setSeries)})}else Qi(bt,{show:!y.show},!0,fn.setSeries)},!1),jt&&xe(Jm,H,pt=>{dt._lock||(Kt(pt),Qi(v.indexOf(y),Kr,!0,fn.setSeries))},!1));for(var lt in de){let pt=ki("td",vv,I);pt.textContent="--",P.push(pt)}return[I,P]}let wn=new Map;function xe(y,M,P,I=!0){let H=wn.get(M)||{},Z=dt.bind[y](n,M,P,I);Z&&(Tr(y,M,H[y]=Z),wn.set(M,H))}function gn(y,M,P){let I=wn.get(M)||{};for(let H in I)(y==null||H==y)&&(Od(H,M,I[H]),delete I[H]);y==null&&wn.delete(M)}let Qe=0,cn=0,U=0,Pt=0,Zt=0,re=0,wt=Zt,Le=re,Vt=U,Yt=Pt,R=0,b=0,X=0,ut=0;n.bbox={};let at=!1,yt=!1,vt=!1,tt=!1,nt=!1,mt=!1;function F(y,M,P){(P||y!=n.width||M!=n.height)&&rt(y,M),le(!1),vt=!0,yt=!0,Fn()}function rt(y,M){n.width=Qe=U=y,n.height=cn=Pt=M,Zt=re=0,St(),Wt();let P=n.bbox;R=P.left=Sr(Zt*Me,.5),b=P.top=Sr(re*Me,.5),X=P.width=Sr(U*Me,.5),ut=P.height=Sr(Pt*Me,.5)}let et=3;function Tt(){let y=!1,M=0;for(;!y;){M++;let P=Xr(M),I=ji(M);y=M==et||P&&I,y||(rt(n.width,n.height),yt=!0)}}function _t({width:y,height:M}){F(y,M)}n.setSize=_t;function St(){let y=!1,M=!1,P=!1,I=!1;A.forEach((H,Z)=>{if(H.show&&H._show){let{side:lt,_size:pt}=H,bt=lt%2,Nt=H.label!=null?H.labelSize:0,Ft=pt+Nt;Ft>0&&(bt?(U-=Ft,lt==3?(Zt+=Ft,I=!0):P=!0):(Pt-=Ft,lt==0?(re+=Ft,y=!0):M=!0))}}),Ji[0]=y,Ji[1]=P,Ji[2]=M,Ji[3]=I,U-=Li[1]+Li[3],Zt+=Li[3],Pt-=Li[2]+Li[0],re+=Li[0]}function Wt(){let y=Zt+U,M=re+Pt,P=Zt,I=re;function H(Z,lt){switch(Z){case 1:return y+=lt,y-lt;case 2:return M+=lt,M-lt;case 3:return P-=lt,P+lt;case 0:return I-=lt,I+lt}}A.forEach((Z,lt)=>{if(Z.show&&Z._show){let pt=Z.side;Z._pos=H(pt,Z._size),Z.label!=null&&(Z._lpos=H(pt,Z.labelSize))}})}if(dt.dataIdx==null){let y=dt.hover,M=y.skip=new Set(y.skip??[]);M.add(void 0);let P=y.prox=_e(y.prox),I=y.bias??=0;dt.dataIdx=(H,Z,lt,pt)=>{if(Z==0)return lt;let bt=lt,Nt=P(H,Z,lt,pt)??De,Ft=Nt>=0&&Nt<De,Ot=D.ori==0?U:Pt,ie=dt.left,Se=t[0],ve=t[Z];if(M.has(ve[lt])){bt=null;let me=null,Jt=null,qt;if(I==0||I==-1)for(qt=lt;me==null&&qt-- >0;)M.has(ve[qt])||(me=qt);if(I==0||I==1)for(qt=lt;Jt==null&&qt++<ve.length;)M.has(ve[qt])||(Jt=qt);if(me!=null||Jt!=null)if(Ft){let He=me==null?-1/0:G(Se[me],D,Ot,0),nn=Jt==null?1/0:G(Se[Jt],D,Ot,0),Rn=ie-He,Ie=nn-ie;Rn<=Ie?Rn<=Nt&&(bt=me):Ie<=Nt&&(bt=Jt)}else bt=Jt==null?me:me==null?Jt:lt-me<=Jt-lt?me:Jt}else Ft&&vn(ie-G(Se[lt],D,Ot,0))>Nt&&(bt=null);return bt}}let Kt=y=>{dt.event=y};dt.idxs=st,dt._lock=!1;let ct=dt.points;ct.show=_e(ct.show),ct.size=_e(ct.size),ct.stroke=_e(ct.stroke),ct.width=_e(ct.width),ct.fill=_e(ct.fill);let Bt=n.focus=pn({},i.focus||{alpha:.3},dt.focus),jt=Bt.prox>=0,Ct=jt&&ct.one,oe=[],ke=[],Vn=[];function jo(y,M){let P=ct.show(n,M);if(P instanceof HTMLElement)return hi(P,pv),hi(P,y.class),ss(P,-10,-10,U,Pt),p.insertBefore(P,oe[M]),P}function Vr(y,M){if(s==1||M>0){let P=s==1&&S[y.scale].time,I=y.value;y.value=P?ug(I)?yg(Y,_g(I,V)):I||j:I||Rb,y.label=y.label||(P?vb:xb)}if(Ct||M>0){y.width=y.width==null?1:y.width,y.paths=y.paths||Vb||Lv,y.fillTo=_e(y.fillTo||Db),y.pxAlign=+be(y.pxAlign,x),y.pxRound=Ag(y.pxAlign),y.stroke=_e(y.stroke||null),y.fill=_e(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=Cb($n(1,y.width),1),I=y.points=pn({},{size:P,width:$n(1,P*.2),stroke:y.stroke,space:P*2,paths:Gb,_stroke:null,_fill:null},y.points);I.show=_e(I.show),I.filter=_e(I.filter),I.fill=_e(I.fill),I.stroke=_e(I.stroke),I.paths=_e(I.paths),I.pxAlign=y.pxAlign}if(Q){let P=Pe(y,M);se.splice(M,0,P[0]),Gt.splice(M,0,P[1]),ft.values.push(null)}if(gt){st.splice(M,0,null);let P=null;Ct?M==0&&(P=jo(y,M)):M>0&&(P=jo(y,M)),oe.splice(M,0,P),ke.splice(M,0,0),Vn.splice(M,0,0)}An("addSeries",M)}function td(y,M){M=M??v.length,y=s==1?Gd(y,M,vg,Tg):Gd(y,M,{},wg),v.splice(M,0,y),Vr(v[M],M)}n.addSeries=td;function vl(y){if(v.splice(y,1),Q){ft.values.splice(y,1),Gt.splice(y,1);let M=se.splice(y,1)[0];gn(null,M.firstChild),M.remove()}gt&&(st.splice(y,1),oe.splice(y,1)[0].remove(),ke.splice(y,1),Vn.splice(y,1)),An("delSeries",y)}n.delSeries=vl;let Ji=[!1,!1,!1,!1];function ms(y,M){if(y._show=y.show,y.show){let P=y.side%2,I=S[y.scale];I==null&&(y.scale=P?v[1].scale:E,I=S[y.scale]);let H=I.time;y.size=_e(y.size),y.space=_e(y.space),y.rotate=_e(y.rotate),Zs(y.incrs)&&y.incrs.forEach(lt=>{!Js.has(lt)&&Js.set(lt,zg(lt))}),y.incrs=_e(y.incrs||(I.distr==2?tb:H?m==1?nb:rb:Mr)),y.splits=_e(y.splits||(H&&I.distr==1?ht:I.distr==3?Bd:I.distr==4?Mb:Sb)),y.stroke=_e(y.stroke),y.grid.stroke=_e(y.grid.stroke),y.ticks.stroke=_e(y.ticks.stroke),y.border.stroke=_e(y.border.stroke);let Z=y.values;y.values=Zs(Z)&&!Zs(Z[0])?_e(Z):H?Zs(Z)?gg(Y,mg(Z,V)):ug(Z)?lb(Y,Z):Z||J:Z||bb,y.filter=_e(y.filter||(I.distr>=3&&I.log==10?Eb:I.distr==3&&I.log==2?Ab:kg)),y.font=Ig(y.font),y.labelFont=Ig(y.labelFont),y._size=y.size(n,null,M,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Ji[M]=!0,y._el=wi(hv,d))}}function gs(y,M,P,I){let[H,Z,lt,pt]=P,bt=M%2,Nt=0;return bt==0&&(pt||Z)&&(Nt=M==0&&!H||M==2&&!lt?xn(xg.size/3):0),bt==1&&(H||lt)&&(Nt=M==1&&!Z||M==3&&!pt?xn(Sg.size/2):0),Nt}let Qo=n.padding=(i.padding||[gs,gs,gs,gs]).map(y=>_e(be(y,gs))),Li=n._padding=Qo.map((y,M)=>y(n,M,Ji,0)),tn,on=null,an=null,Ki=s==1?v[0].idxs:null,oi=null,Bs=!1;function ta(y,M){if(t=y??[],n.data=n._data=t,s==2){tn=0;for(let P=1;P<v.length;P++)tn+=t[P][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),oi=t[0],tn=oi.length;let P=t;if(z==2){P=t.slice();let I=P[0]=Array(tn);for(let H=0;H<tn;H++)I[H]=H}n._data=t=P}if(le(!0),An("setData"),z==2&&(vt=!0),M!==!1){let P=D;P.auto(n,Bs)?ea():Vs(E,P.min,P.max),tt=tt||dt.left>=0,mt=!0,Fn()}}n.setData=ta;function ea(){Bs=!0;let y,M;s==1&&(tn>0?(on=Ki[0]=0,an=Ki[1]=tn-1,y=t[0][on],M=t[0][an],z==2?(y=on,M=an):y==M&&(z==3?[y,M]=ac(y,y,D.log,!1):z==4?[y,M]=Yd(y,y,D.log,!1):D.time?M=y+xn(86400/m):[y,M]=sc(y,M,$d,!0))):(on=Ki[0]=y=null,an=Ki[1]=M=null)),Vs(E,y,M)}let Gr,zs,Wr,w,k,K,q,$,Et,It;function At(y,M,P,I,H,Z){y??=$m,P??=Jd,I??="butt",H??=$m,Z??="round",y!=Gr&&(u.strokeStyle=Gr=y),H!=zs&&(u.fillStyle=zs=H),M!=Wr&&(u.lineWidth=Wr=M),Z!=k&&(u.lineJoin=k=Z),I!=K&&(u.lineCap=K=I),P!=w&&u.setLineDash(w=P)}function Lt(y,M,P,I){M!=zs&&(u.fillStyle=zs=M),y!=q&&(u.font=q=y),P!=$&&(u.textAlign=$=P),I!=Et&&(u.textBaseline=Et=I)}function Ht(y,M,P,I,H=0){if(I.length>0&&y.auto(n,Bs)&&(M==null||M.min==null)){let Z=be(on,0),lt=be(an,I.length-1),pt=P.min==null?Ev(I,Z,lt,H,y.distr==3):[P.min,P.max];y.min=zi(y.min,P.min=pt[0]),y.max=$n(y.max,P.max=pt[1])}}let Qt={min:null,max:null};function fe(){for(let I in S){let H=S[I];W[I]==null&&(H.min==null||W[E]!=null&&H.auto(n,Bs))&&(W[I]=Qt)}for(let I in S){let H=S[I];W[I]==null&&H.from!=null&&W[H.from]!=null&&(W[I]=Qt)}W[E]!=null&&le(!0);let y={};for(let I in W){let H=W[I];if(H!=null){let Z=y[I]=uo(S[I],Fv);if(H.min!=null)pn(Z,H);else if(I!=E||s==2)if(tn==0&&Z.from==null){let lt=Z.range(n,null,null,I);Z.min=lt[0],Z.max=lt[1]}else Z.min=De,Z.max=-De}}if(tn>0){v.forEach((I,H)=>{if(s==1){let Z=I.scale,lt=W[Z];if(lt==null)return;let pt=y[Z];if(H==0){let bt=pt.range(n,pt.min,pt.max,Z);pt.min=bt[0],pt.max=bt[1],on=Bi(pt.min,t[0]),an=Bi(pt.max,t[0]),an-on>1&&(t[0][on]<pt.min&&on++,t[0][an]>pt.max&&an--),I.min=oi[on],I.max=oi[an]}else I.show&&I.auto&&Ht(pt,lt,I,t[H],I.sorted);I.idxs[0]=on,I.idxs[1]=an}else if(H>0&&I.show&&I.auto){let[Z,lt]=I.facets,pt=Z.scale,bt=lt.scale,[Nt,Ft]=t[H],Ot=y[pt],ie=y[bt];Ot!=null&&Ht(Ot,W[pt],Z,Nt,Z.sorted),ie!=null&&Ht(ie,W[bt],lt,Ft,lt.sorted),I.min=lt.min,I.max=lt.max}});for(let I in y){let H=y[I],Z=W[I];if(H.from==null&&(Z==null||Z.min==null)){let lt=H.range(n,H.min==De?null:H.min,H.max==-De?null:H.max,I);H.min=lt[0],H.max=lt[1]}}}for(let I in y){let H=y[I];if(H.from!=null){let Z=y[H.from];if(Z.min==null)H.min=H.max=null;else{let lt=H.range(n,Z.min,Z.max,I);H.min=lt[0],H.max=lt[1]}}}let M={},P=!1;for(let I in y){let H=y[I],Z=S[I];if(Z.min!=H.min||Z.max!=H.max){Z.min=H.min,Z.max=H.max;let lt=Z.distr;Z._min=lt==3?bs(Z.min):lt==4?Pd(Z.min,Z.asinh):lt==100?Z.fwd(Z.min):Z.min,Z._max=lt==3?bs(Z.max):lt==4?Pd(Z.max,Z.asinh):lt==100?Z.fwd(Z.max):Z.max,M[I]=P=!0}}if(P){v.forEach((I,H)=>{s==2?H>0&&M.y&&(I._paths=null):M[I.scale]&&(I._paths=null)});for(let I in M)vt=!0,An("setScale",I);gt&&dt.left>=0&&(tt=mt=!0)}for(let I in W)W[I]=null}function zt(y){let M=kd(on-1,0,tn-1),P=kd(an+1,0,tn-1);for(;y[M]==null&&M>0;)M--;for(;y[P]==null&&P<tn-1;)P++;return[M,P]}function pe(){if(tn>0){let y=v.some(M=>M._focus)&&It!=Bt.alpha;y&&(u.globalAlpha=It=Bt.alpha),v.forEach((M,P)=>{if(P>0&&M.show&&(Ze(P,!1),Ze(P,!0),M._paths==null)){let I=It;It!=M.alpha&&(u.globalAlpha=It=M.alpha);let H=s==2?[0,t[P][0].length-1]:zt(t[P]);M._paths=M.paths(n,P,H[0],H[1]),It!=I&&(u.globalAlpha=It=I)}}),v.forEach((M,P)=>{if(P>0&&M.show){let I=It;It!=M.alpha&&(u.globalAlpha=It=M.alpha),M._paths!=null&&Ae(P,!1);{let H=M._paths!=null?M._paths.gaps:null,Z=M.points.show(n,P,on,an,H),lt=M.points.filter(n,P,Z,H);(Z||lt)&&(M.points._paths=M.points.paths(n,P,on,an,lt),Ae(P,!0))}It!=I&&(u.globalAlpha=It=I),An("drawSeries",P)}}),y&&(u.globalAlpha=It=1)}}function Ze(y,M){let P=M?v[y].points:v[y];P._stroke=P.stroke(n,y),P._fill=P.fill(n,y)}function Ae(y,M){let P=M?v[y].points:v[y],{stroke:I,fill:H,clip:Z,flags:lt,_stroke:pt=P._stroke,_fill:bt=P._fill,_width:Nt=P.width}=P._paths;Nt=Ne(Nt*Me,3);let Ft=null,Ot=Nt%2/2;M&&bt==null&&(bt=Nt>0?"#fff":pt);let ie=P.pxAlign==1&&Ot>0;if(ie&&u.translate(Ot,Ot),!M){let Se=R-Nt/2,ve=b-Nt/2,me=X+Nt,Jt=ut+Nt;Ft=new Path2D,Ft.rect(Se,ve,me,Jt)}M?Ut(pt,Nt,P.dash,P.cap,bt,I,H,lt,Z):Re(y,pt,Nt,P.dash,P.cap,bt,I,H,lt,Ft,Z),ie&&u.translate(-Ot,-Ot)}function Re(y,M,P,I,H,Z,lt,pt,bt,Nt,Ft){let Ot=!1;bt!=0&&C.forEach((ie,Se)=>{if(ie.series[0]==y){let ve=v[ie.series[1]],me=t[ie.series[1]],Jt=(ve._paths||va).band;Zs(Jt)&&(Jt=ie.dir==1?Jt[0]:Jt[1]);let qt,He=null;ve.show&&Jt&&Rv(me,on,an)?(He=ie.fill(n,Se)||Z,qt=ve._paths.clip):Jt=null,Ut(M,P,I,H,He,lt,pt,bt,Nt,Ft,qt,Jt),Ot=!0}}),Ot||Ut(M,P,I,H,Z,lt,pt,bt,Nt,Ft)}let _n=fo|Hd;function Ut(y,M,P,I,H,Z,lt,pt,bt,Nt,Ft,Ot){At(y,M,P,I,H),(bt||Nt||Ot)&&(u.save(),bt&&u.clip(bt),Nt&&u.clip(Nt)),Ot?(pt&_n)==_n?(u.clip(Ot),Ft&&u.clip(Ft),ge(H,lt),hn(y,Z,M)):pt&Hd?(ge(H,lt),u.clip(Ot),hn(y,Z,M)):pt&fo&&(u.save(),u.clip(Ot),Ft&&u.clip(Ft),ge(H,lt),u.restore(),hn(y,Z,M)):(ge(H,lt),hn(y,Z,M)),(bt||Nt||Ot)&&u.restore()}function hn(y,M,P){P>0&&(M instanceof Map?M.forEach((I,H)=>{u.strokeStyle=Gr=H,u.stroke(I)}):M!=null&&y&&u.stroke(M))}function ge(y,M){M instanceof Map?M.forEach((P,I)=>{u.fillStyle=zs=I,u.fill(P)}):M!=null&&y&&u.fill(M)}function _s(y,M,P,I){let H=A[y],Z;if(I<=0)Z=[0,0];else{let lt=H._space=H.space(n,y,M,P,I),pt=H._incrs=H.incrs(n,y,M,P,I,lt);Z=Zb(M,P,pt,I,lt)}return H._found=Z}function un(y,M,P,I,H,Z,lt,pt,bt,Nt){let Ft=lt%2/2;x==1&&u.translate(Ft,Ft),At(pt,lt,bt,Nt,pt),u.beginPath();let Ot,ie,Se,ve,me=H+(I==0||I==3?-Z:Z);P==0?(ie=H,ve=me):(Ot=H,Se=me);for(let Jt=0;Jt<y.length;Jt++)M[Jt]!=null&&(P==0?Ot=Se=y[Jt]:ie=ve=y[Jt],u.moveTo(Ot,ie),u.lineTo(Se,ve));u.stroke(),x==1&&u.translate(-Ft,-Ft)}function Xr(y){let M=!0;return A.forEach((P,I)=>{if(!P.show)return;let H=S[P.scale];if(H.min==null){P._show&&(M=!1,P._show=!1,le(!1));return}else P._show||(M=!1,P._show=!0,le(!1));let Z=P.side,lt=Z%2,{min:pt,max:bt}=H,[Nt,Ft]=_s(I,pt,bt,lt==0?U:Pt);if(Ft==0)return;let Ot=H.distr==2,ie=P._splits=P.splits(n,I,pt,bt,Nt,Ft,Ot),Se=H.distr==2?ie.map(qt=>oi[qt]):ie,ve=H.distr==2?oi[ie[1]]-oi[ie[0]]:Nt,me=P._values=P.values(n,P.filter(n,Se,I,Ft,ve),I,Ft,ve);P._rotate=Z==2?P.rotate(n,me,I,Ft):0;let Jt=P._size;P._size=Ti(P.size(n,me,I,y)),Jt!=null&&P._size!=Jt&&(M=!1)}),M}function ji(y){let M=!0;return Qo.forEach((P,I)=>{let H=P(n,I,Ji,y);H!=Li[I]&&(M=!1),Li[I]=H}),M}function ys(){for(let y=0;y<A.length;y++){let M=A[y];if(!M.show||!M._show)continue;let P=M.side,I=P%2,H,Z,lt=M.stroke(n,y),pt=P==0||P==3?-1:1,[bt,Nt]=M._found;if(M.label!=null){let Xn=M.labelGap*pt,ci=xn((M._lpos+Xn)*Me);Lt(M.labelFont[0],lt,"center",P==2?"top":Ym),u.save(),I==1?(H=Z=0,u.translate(ci,xn(b+ut/2)),u.rotate((P==3?-nc:nc)/2)):(H=xn(R+X/2),Z=ci);let xr=Ug(M.label)?M.label(n,y,bt,Nt):M.label;u.fillText(xr,H,Z),u.restore()}if(Nt==0)continue;let Ft=S[M.scale],Ot=I==0?X:ut,ie=I==0?R:b,Se=M._splits,ve=Ft.distr==2?Se.map(Xn=>oi[Xn]):Se,me=Ft.distr==2?oi[Se[1]]-oi[Se[0]]:bt,Jt=M.ticks,qt=M.border,He=Jt.show?Jt.size:0,nn=xn(He*Me),Rn=xn((M.alignTo==2?M._size-He-M.gap:M.gap)*Me),Ie=M._rotate*-nc/180,sn=g(M._pos*Me),ai=(nn+Rn)*pt,Wn=sn+ai;Z=I==0?Wn:0,H=I==1?Wn:0;let vi=M.font[0],Di=M.align==1?oo:M.align==2?Ad:Ie>0?oo:Ie<0?Ad:I==0?"center":P==3?Ad:oo,es=Ie||I==1?"middle":P==2?"top":Ym;Lt(vi,lt,Di,es);let li=M.font[1]*M.lineGap,bi=Se.map(Xn=>g(a(Xn,Ft,Ot,ie))),Ni=M._values;for(let Xn=0;Xn<Ni.length;Xn++){let ci=Ni[Xn];if(ci!=null){I==0?H=bi[Xn]:Z=bi[Xn],ci=""+ci;let xr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let qn=0;qn<xr.length;qn++){let om=xr[qn];Ie?(u.save(),u.translate(H,Z+qn*li),u.rotate(Ie),u.fillText(om,0,0),u.restore()):u.fillText(om,H,Z+qn*li)}}}Jt.show&&un(bi,Jt.filter(n,ve,y,Nt,me),I,P,sn,nn,Ne(Jt.width*Me,3),Jt.stroke(n,y),Jt.dash,Jt.cap);let ns=M.grid;ns.show&&un(bi,ns.filter(n,ve,y,Nt,me),I,I==0?2:1,I==0?b:R,I==0?ut:X,Ne(ns.width*Me,3),ns.stroke(n,y),ns.dash,ns.cap),qt.show&&un([sn],[1],I==0?1:0,I==0?1:2,I==1?b:R,I==1?ut:X,Ne(qt.width*Me,3),qt.stroke(n,y),qt.dash,qt.cap)}An("drawAxes")}function le(y){v.forEach((M,P)=>{P>0&&(M._paths=null,y&&(s==1?(M.min=null,M.max=null):M.facets.forEach(I=>{I.min=null,I.max=null})))})}let en=!1,Gn=!1,Ce=[];function dn(){Gn=!1;for(let y=0;y<Ce.length;y++)An(...Ce[y]);Ce.length=0}function Fn(){en||(Vv(Vp),en=!0)}function bl(y,M=!1){en=!0,Gn=M,y(n),Vp(),M&&Ce.length>0&&queueMicrotask(dn)}n.batch=bl;function Vp(){if(at&&(fe(),at=!1),vt&&(Tt(),vt=!1),yt){if(Ge(f,oo,Zt),Ge(f,"top",re),Ge(f,ga,U),Ge(f,_a,Pt),Ge(p,oo,Zt),Ge(p,"top",re),Ge(p,ga,U),Ge(p,_a,Pt),Ge(d,ga,Qe),Ge(d,_a,cn),h.width=xn(Qe*Me),h.height=xn(cn*Me),A.forEach(({_el:y,_show:M,_size:P,_pos:I,side:H})=>{if(y!=null)if(M){let Z=H===3||H===0?P:0,lt=H%2==1;Ge(y,lt?"left":"top",I-Z),Ge(y,lt?"width":"height",P),Ge(y,lt?"top":"left",lt?re:Zt),Ge(y,lt?"height":"width",lt?Pt:U),Ud(y,wr)}else hi(y,wr)}),Gr=zs=Wr=k=K=q=$=Et=w=null,It=1,sa(!0),Zt!=wt||re!=Le||U!=Vt||Pt!=Yt){le(!1);let y=U/Vt,M=Pt/Yt;if(gt&&!tt&&dt.left>=0){dt.left*=y,dt.top*=M,qr&&ss(qr,xn(dt.left),0,U,Pt),Yr&&ss(Yr,0,xn(dt.top),U,Pt);for(let P=0;P<oe.length;P++){let I=oe[P];I!=null&&(ke[P]*=y,Vn[P]*=M,ss(I,Ti(ke[P]),Ti(Vn[P]),U,Pt))}}if(ze.show&&!nt&&ze.left>=0&&ze.width>0){ze.left*=y,ze.width*=y,ze.top*=M,ze.height*=M;for(let P in od)Ge(Jr,P,ze[P])}wt=Zt,Le=re,Vt=U,Yt=Pt}An("setSize"),yt=!1}Qe>0&&cn>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),T.forEach(y=>y()),An("draw")),ze.show&&nt&&(Sl(ze),nt=!1),gt&&tt&&(yr(null,!0,!1),tt=!1),ft.show&&ft.live&&mt&&(sd(),mt=!1),l||(l=!0,n.status=1,An("ready")),Bs=!1,en=!1}n.redraw=(y,M)=>{vt=M||!1,y!==!1?Vs(E,D.min,D.max):Fn()};function ed(y,M){let P=S[y];if(P.from==null){if(tn==0){let I=P.range(n,M.min,M.max,y);M.min=I[0],M.max=I[1]}if(M.min>M.max){let I=M.min;M.min=M.max,M.max=I}if(tn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;y==E&&P.distr==2&&tn>0&&(M.min=Bi(M.min,t[0]),M.max=Bi(M.max,t[0]),M.min==M.max&&M.max++),W[y]=M,at=!0,Fn()}}n.setScale=ed;let nd,id,qr,Yr,Gp,Wp,$r,Zr,Xp,qp,Be,Ye,Hs=!1,In=dt.drag,Tn=In.x,En=In.y;gt&&(dt.x&&(nd=wi(dv,p)),dt.y&&(id=wi(fv,p)),D.ori==0?(qr=nd,Yr=id):(qr=id,Yr=nd),Be=dt.left,Ye=dt.top);let ze=n.select=pn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Jr=ze.show?wi(uv,ze.over?p:f):null;function Sl(y,M){if(ze.show){for(let P in y)ze[P]=y[P],P in od&&Ge(Jr,P,y[P]);M!==!1&&An("setSelect")}}n.setSelect=Sl;function sx(y){if(v[y].show)Q&&Ud(se[y],wr);else if(Q&&hi(se[y],wr),gt){let P=Ct?oe[0]:oe[y];P!=null&&ss(P,-10,-10,U,Pt)}}function Vs(y,M,P){ed(y,{min:M,max:P})}function Qi(y,M,P,I){M.focus!=null&&cx(y),M.show!=null&&v.forEach((H,Z)=>{Z>0&&(y==Z||y==null)&&(H.show=M.show,sx(Z),s==2?(Vs(H.facets[0].scale,null,null),Vs(H.facets[1].scale,null,null)):Vs(H.scale,null,null),Fn())}),P!==!1&&An("setSeries",y,M),I&&ra("setSeries",n,y,M)}n.setSeries=Qi;function rx(y,M){pn(C[y],M)}function ox(y,M){y.fill=_e(y.fill||null),y.dir=be(y.dir,-1),M=M??C.length,C.splice(M,0,y)}function ax(y){y==null?C.length=0:C.splice(y,1)}n.addBand=ox,n.setBand=rx,n.delBand=ax;function lx(y,M){v[y].alpha=M,gt&&oe[y]!=null&&(oe[y].style.opacity=M),Q&&se[y]&&(se[y].style.opacity=M)}let xs,Gs,_r,Kr={focus:!0};function cx(y){if(y!=_r){let M=y==null,P=Bt.alpha!=1;v.forEach((I,H)=>{if(s==1||H>0){let Z=M||H==0||H==y;I._focus=M?null:Z,P&&lx(H,Z?1:Bt.alpha)}}),_r=y,P&&Fn()}}Q&&jt&&xe(Km,Rt,y=>{dt._lock||(Kt(y),_r!=null&&Qi(null,Kr,!0,fn.setSeries))});function ts(y,M,P){let I=S[M];P&&(y=y/Me-(I.ori==1?re:Zt));let H=U;I.ori==1&&(H=Pt,y=H-y),I.dir==-1&&(y=H-y);let Z=I._min,lt=I._max,pt=y/H,bt=Z+(lt-Z)*pt,Nt=I.distr;return Nt==3?co(10,bt):Nt==4?Pv(bt,I.asinh):Nt==100?I.bwd(bt):bt}function hx(y,M){let P=ts(y,E,M);return Bi(P,t[0],on,an)}n.valToIdx=y=>Bi(y,t[0]),n.posToIdx=hx,n.posToVal=ts,n.valToPos=(y,M,P)=>S[M].ori==0?r(y,S[M],P?X:U,P?R:0):o(y,S[M],P?ut:Pt,P?b:0),n.setCursor=(y,M,P)=>{Be=y.left,Ye=y.top,yr(null,M,P)};function Yp(y,M){Ge(Jr,oo,ze.left=y),Ge(Jr,ga,ze.width=M)}function $p(y,M){Ge(Jr,"top",ze.top=y),Ge(Jr,_a,ze.height=M)}let na=D.ori==0?Yp:$p,ia=D.ori==1?Yp:$p;function ux(){if(Q&&ft.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&ae)continue;let M=ft.values[y],P=0;for(let I in M)Gt[y][P++].firstChild.nodeValue=M[I]}}function sd(y,M){if(y!=null&&(y.idxs?y.idxs.forEach((P,I)=>{st[I]=P}):Nv(y.idx)||st.fill(y.idx),ft.idx=st[0]),Q&&ft.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ae)&&dx(P,st[P]);ux()}mt=!1,M!==!1&&An("setLegend")}n.setLegend=sd;function dx(y,M){let P=v[y],I=y==0&&z==2?oi:t[y],H;ae?H=P.values(n,y,M)??ne:(H=P.value(n,M==null?null:I[M],y,M),H=H==null?ne:{_:H}),ft.values[y]=H}function yr(y,M,P){Xp=Be,qp=Ye,[Be,Ye]=dt.move(n,Be,Ye),dt.left=Be,dt.top=Ye,gt&&(qr&&ss(qr,xn(Be),0,U,Pt),Yr&&ss(Yr,0,xn(Ye),U,Pt));let I,H=on>an;xs=De,Gs=null;let Z=D.ori==0?U:Pt,lt=D.ori==1?U:Pt;if(Be<0||tn==0||H){I=dt.idx=null;for(let pt=0;pt<v.length;pt++){let bt=oe[pt];bt!=null&&ss(bt,-10,-10,U,Pt)}jt&&Qi(null,Kr,!0,y==null&&fn.setSeries),ft.live&&(st.fill(I),mt=!0)}else{let pt,bt,Nt;s==1&&(pt=D.ori==0?Be:Ye,bt=ts(pt,E),I=dt.idx=Bi(bt,t[0],on,an),Nt=G(t[0][I],D,Z,0));let Ft=-10,Ot=-10,ie=0,Se=0,ve=!0,me="",Jt="";for(let qt=s==2?1:0;qt<v.length;qt++){let He=v[qt],nn=st[qt],Rn=nn==null?null:s==1?t[qt][nn]:t[qt][1][nn],Ie=dt.dataIdx(n,qt,I,bt),sn=Ie==null?null:s==1?t[qt][Ie]:t[qt][1][Ie];if(mt=mt||sn!=Rn||Ie!=nn,st[qt]=Ie,qt>0&&He.show){let ai=Ie==null?-10:Ie==I?Nt:G(s==1?t[0][Ie]:t[qt][0][Ie],D,Z,0),Wn=sn==null?-10:L(sn,s==1?S[He.scale]:S[He.facets[1].scale],lt,0);if(jt&&sn!=null){let vi=D.ori==1?Be:Ye,Di=vn(Bt.dist(n,qt,Ie,Wn,vi));if(Di<xs){let es=Bt.bias;if(es!=0){let li=ts(vi,He.scale),bi=sn>=0?1:-1,Ni=li>=0?1:-1;Ni==bi&&(Ni==1?es==1?sn>=li:sn<=li:es==1?sn<=li:sn>=li)&&(xs=Di,Gs=qt)}else xs=Di,Gs=qt}}if(mt||Ct){let vi,Di;D.ori==0?(vi=ai,Di=Wn):(vi=Wn,Di=ai);let es,li,bi,Ni,ns,Xn,ci=!0,xr=ct.bbox;if(xr!=null){ci=!1;let qn=xr(n,qt);bi=qn.left,Ni=qn.top,es=qn.width,li=qn.height}else bi=vi,Ni=Di,es=li=ct.size(n,qt);if(Xn=ct.fill(n,qt),ns=ct.stroke(n,qt),Ct)qt==Gs&&xs<=Bt.prox&&(Ft=bi,Ot=Ni,ie=es,Se=li,ve=ci,me=Xn,Jt=ns);else{let qn=oe[qt];qn!=null&&(ke[qt]=bi,Vn[qt]=Ni,sg(qn,es,li,ci),ng(qn,Xn,ns),ss(qn,Ti(bi),Ti(Ni),U,Pt))}}}}if(Ct){let qt=Bt.prox,He=_r==null?xs<=qt:xs>qt||Gs!=_r;if(mt||He){let nn=oe[0];nn!=null&&(ke[0]=Ft,Vn[0]=Ot,sg(nn,ie,Se,ve),ng(nn,me,Jt),ss(nn,Ti(Ft),Ti(Ot),U,Pt))}}}if(ze.show&&Hs)if(y!=null){let[pt,bt]=fn.scales,[Nt,Ft]=fn.match,[Ot,ie]=y.cursor.sync.scales,Se=y.cursor.drag;if(Tn=Se._x,En=Se._y,Tn||En){let{left:ve,top:me,width:Jt,height:qt}=y.select,He=y.scales[Ot].ori,nn=y.posToVal,Rn,Ie,sn,ai,Wn,vi=pt!=null&&Nt(pt,Ot),Di=bt!=null&&Ft(bt,ie);vi&&Tn?(He==0?(Rn=ve,Ie=Jt):(Rn=me,Ie=qt),sn=S[pt],ai=G(nn(Rn,Ot),sn,Z,0),Wn=G(nn(Rn+Ie,Ot),sn,Z,0),na(zi(ai,Wn),vn(Wn-ai))):na(0,Z),Di&&En?(He==1?(Rn=ve,Ie=Jt):(Rn=me,Ie=qt),sn=S[bt],ai=L(nn(Rn,ie),sn,lt,0),Wn=L(nn(Rn+Ie,ie),sn,lt,0),ia(zi(ai,Wn),vn(Wn-ai))):ia(0,lt)}else ad()}else{let pt=vn(Xp-Gp),bt=vn(qp-Wp);if(D.ori==1){let ie=pt;pt=bt,bt=ie}Tn=In.x&&pt>=In.dist,En=In.y&&bt>=In.dist;let Nt=In.uni;Nt!=null?Tn&&En&&(Tn=pt>=Nt,En=bt>=Nt,!Tn&&!En&&(bt>pt?En=!0:Tn=!0)):In.x&&In.y&&(Tn||En)&&(Tn=En=!0);let Ft,Ot;Tn&&(D.ori==0?(Ft=$r,Ot=Be):(Ft=Zr,Ot=Ye),na(zi(Ft,Ot),vn(Ot-Ft)),En||ia(0,lt)),En&&(D.ori==1?(Ft=$r,Ot=Be):(Ft=Zr,Ot=Ye),ia(zi(Ft,Ot),vn(Ot-Ft)),Tn||na(0,Z)),!Tn&&!En&&(na(0,0),ia(0,0))}if(In._x=Tn,In._y=En,y==null){if(P){if(rm!=null){let[pt,bt]=fn.scales;fn.values[0]=pt!=null?ts(D.ori==0?Be:Ye,pt):null,fn.values[1]=bt!=null?ts(D.ori==1?Be:Ye,bt):null}ra(Rd,n,Be,Ye,U,Pt,I)}if(jt){let pt=P&&fn.setSeries,bt=Bt.prox;_r==null?xs<=bt&&Qi(Gs,Kr,!0,pt):xs>bt?Qi(null,Kr,!0,pt):Gs!=_r&&Qi(Gs,Kr,!0,pt)}}mt&&(ft.idx=I,sd()),M!==!1&&An("setCursor")}let Ws=null;Object.defineProperty(n,"rect",{get(){return Ws==null&&sa(!1),Ws}});function sa(y=!1){y?Ws=null:(Ws=p.getBoundingClientRect(),An("syncRect",Ws))}function Zp(y,M,P,I,H,Z,lt){dt._lock||Hs&&y!=null&&y.movementX==0&&y.movementY==0||(rd(y,M,P,I,H,Z,lt,!1,y!=null),y!=null?yr(null,!0,!0):yr(M,!0,!1))}function rd(y,M,P,I,H,Z,lt,pt,bt){if(Ws==null&&sa(!1),Kt(y),y!=null)P=y.clientX-Ws.left,I=y.clientY-Ws.top;else{if(P<0||I<0){Be=-10,Ye=-10;return}let[Nt,Ft]=fn.scales,Ot=M.cursor.sync,[ie,Se]=Ot.values,[ve,me]=Ot.scales,[Jt,qt]=fn.match,He=M.axes[0].side%2==1,nn=D.ori==0?U:Pt,Rn=D.ori==1?U:Pt,Ie=He?Z:H,sn=He?H:Z,ai=He?I:P,Wn=He?P:I;if(ve!=null?P=Jt(Nt,ve)?a(ie,S[Nt],nn,0):-10:P=nn*(ai/Ie),me!=null?I=qt(Ft,me)?a(Se,S[Ft],Rn,0):-10:I=Rn*(Wn/sn),D.ori==1){let vi=P;P=I,I=vi}}bt&&(M==null||M.cursor.event.type==Rd)&&((P<=1||P>=U-1)&&(P=Sr(P,U)),(I<=1||I>=Pt-1)&&(I=Sr(I,Pt))),pt?(Gp=P,Wp=I,[$r,Zr]=dt.move(n,P,I)):(Be=P,Ye=I)}let od={width:0,height:0,left:0,top:0};function ad(){Sl(od,!1)}let Jp,Kp,jp,Qp;function tm(y,M,P,I,H,Z,lt){Hs=!0,Tn=En=In._x=In._y=!1,rd(y,M,P,I,H,Z,lt,!0,!1),y!=null&&(xe(Cd,Nd,em,!1),ra(Zm,n,$r,Zr,U,Pt,null));let{left:pt,top:bt,width:Nt,height:Ft}=ze;Jp=pt,Kp=bt,jp=Nt,Qp=Ft}function em(y,M,P,I,H,Z,lt){Hs=In._x=In._y=!1,rd(y,M,P,I,H,Z,lt,!1,!0);let{left:pt,top:bt,width:Nt,height:Ft}=ze,Ot=Nt>0||Ft>0,ie=Jp!=pt||Kp!=bt||jp!=Nt||Qp!=Ft;if(Ot&&ie&&Sl(ze),In.setScale&&Ot&&ie){let Se=pt,ve=Nt,me=bt,Jt=Ft;if(D.ori==1&&(Se=bt,ve=Ft,me=pt,Jt=Nt),Tn&&Vs(E,ts(Se,E),ts(Se+ve,E)),En)for(let qt in S){let He=S[qt];qt!=E&&He.from==null&&He.min!=De&&Vs(qt,ts(me+Jt,qt),ts(me,qt))}ad()}else dt.lock&&(dt._lock=!dt._lock,yr(M,!0,y!=null));y!=null&&(gn(Cd,Nd),ra(Cd,n,Be,Ye,U,Pt,null))}function fx(y,M,P,I,H,Z,lt){if(dt._lock)return;Kt(y);let pt=Hs;if(Hs){let bt=!0,Nt=!0,Ft=10,Ot,ie;D.ori==0?(Ot=Tn,ie=En):(Ot=En,ie=Tn),Ot&&ie&&(bt=Be<=Ft||Be>=U-Ft,Nt=Ye<=Ft||Ye>=Pt-Ft),Ot&&bt&&(Be=Be<$r?0:U),ie&&Nt&&(Ye=Ye<Zr?0:Pt),yr(null,!0,!0),Hs=!1}Be=-10,Ye=-10,st.fill(null),yr(null,!0,!0),pt&&(Hs=pt)}function nm(y,M,P,I,H,Z,lt){dt._lock||(Kt(y),ea(),ad(),y!=null&&ra(jm,n,Be,Ye,U,Pt,null))}function im(){A.forEach(Jb),F(n.width,n.height,!0)}Tr(ic,lo,im);let jr={};jr.mousedown=tm,jr.mousemove=Zp,jr.mouseup=em,jr.dblclick=nm,jr.setSeries=(y,M,P,I)=>{let H=fn.match[2];P=H(n,M,P),P!=-1&&Qi(P,I,!0,!1)},gt&&(xe(Zm,p,tm),xe(Rd,p,Zp),xe(Jm,p,y=>{Kt(y),sa(!1)}),xe(Km,p,fx),xe(jm,p,nm),Vd.add(n),n.syncRect=sa);let Ml=n.hooks=i.hooks||{};function An(y,M,P){Gn?Ce.push([y,M,P]):y in Ml&&Ml[y].forEach(I=>{I.call(null,n,M,P)})}(i.plugins||[]).forEach(y=>{for(let M in y.hooks)Ml[M]=(Ml[M]||[]).concat(y.hooks[M])});let sm=(y,M,P)=>P,fn=pn({key:null,setSeries:!1,filters:{pub:cg,sub:cg},scales:[E,v[1]?v[1].scale:null],match:[hg,hg,sm],values:[null,null]},dt.sync);fn.match.length==2&&fn.match.push(sm),dt.sync=fn;let rm=fn.key,ld=o0(rm);function ra(y,M,P,I,H,Z,lt){fn.filters.pub(y,M,P,I,H,Z,lt)&&ld.pub(y,M,P,I,H,Z,lt)}ld.sub(n);function px(y,M,P,I,H,Z,lt){fn.filters.sub(y,M,P,I,H,Z,lt)&&jr[y](null,M,P,I,H,Z,lt)}n.pub=px;function mx(){ld.unsub(n),Vd.delete(n),wn.clear(),Od(ic,lo,im),c.remove(),Rt?.remove(),An("destroy")}n.destroy=mx;function cd(){An("init",i,t),ta(t||i.data,!1),W[E]?ed(E,W[E]):ea(),nt=ze.show&&(ze.width>0||ze.height>0),tt=mt=!0,F(i.width,i.height)}return v.forEach(Vr),A.forEach(ms),e?e instanceof HTMLElement?(e.appendChild(c),cd()):e(n,cd):cd(),n}Dn.assign=pn;Dn.fmtNum=Zd;Dn.rangeNum=sc;Dn.rangeLog=ac;Dn.rangeAsinh=Yd;Dn.orient=Ar;Dn.pxRatio=Me;Dn.join=Hv;Dn.fmtDate=Kd,Dn.tzDate=jv;Dn.sync=o0;{Dn.addGap=Nb,Dn.clipGaps=hc;let i=Dn.paths={points:d0};i.linear=p0,i.stepped=Ob,i.bars=kb,i.spline=zb}var rf="http://www.w3.org/2000/svg",pc=class{root=it("ul",{class:"legend"});#t=[];list(t){this.#t=t.map(({unlisted:s,says:r})=>s||!r?null:it("span",{class:"legend-value"}));let e=s=>{let r=this.#t[t.indexOf(s)];return it("li",{},Kb(s),s.label,...r?[" ",r]:[])},n=t.filter(({unlisted:s})=>!s);this.root.replaceChildren(...n.filter(({alpha:s})=>!s).map(e),...n.filter(({alpha:s})=>s).map(e))}say(t){this.#t.forEach((e,n)=>e&&rn(e,t[n]??""))}};function Kb({token:i,dash:t,width:e,alpha:n,marker:s}){let r=document.createElementNS(rf,"svg");for(let[l,c]of Object.entries({width:"22",height:"10",viewBox:"0 0 22 10","aria-hidden":"true"}))r.setAttribute(l,c);let o=document.createElementNS(rf,"line"),a={x1:"0",x2:"22",y1:"5",y2:"5","stroke-width":`${e??1.6}`,"stroke-dasharray":(t??[]).join(" "),opacity:`${n??1}`};for(let[l,c]of Object.entries(a))o.setAttribute(l,c);return o.style.stroke=`var(--${i})`,r.append(o),s&&r.append(jb(s,i)),r}function jb(i,t){let e=document.createElementNS(rf,"path"),n={disc:"M7.5 5a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0z",square:"M8 2h6v6h-6z",diamond:"M11 1l4 4l-4 4l-4 -4z",triangle:"M11 1l4 7h-8z"};return e.setAttribute("d",n[i]),e.style.fill=`var(--${t})`,e}function y0(i,t,e,n){let{ctx:s}=i,r=devicePixelRatio,o=i.data[0],a=i.bbox.width/Math.max(1,o.length),l=Math.min(3.2*r,Math.max(1.2*r,a*.32));s.save(),s.fillStyle=t.dash?n:e,s.strokeStyle=e,s.globalAlpha=t.alpha??1,s.lineWidth=r,s.beginPath();for(let c=0;c<t.values.length;c++){let h=t.values[c];h>0&&Qb(s,t.marker,i.valToPos(o[c],"x",!0),i.valToPos(h,"y",!0),l)}s.fill(),s.stroke(),s.restore()}function Qb(i,t,e,n,s){if(t==="disc")i.moveTo(e+s,n),i.arc(e,n,s,0,2*Math.PI);else if(t==="square")i.rect(e-s,n-s,2*s,2*s);else{let r=1.3*s;i.moveTo(e,n-r),i.lineTo(e+r,t==="diamond"?n:n+r),i.lineTo(t==="diamond"?e:e-r,n+r),t==="diamond"&&i.lineTo(e-r,n),i.closePath()}}function x0(i,t,e,n){let{bbox:s,scales:r}=i,[o,a]=[i.data[0],i.data[t]],[l,c]=[r.x.min,r.x.max],h=s.width/(c-l),u=eS(i),d=new Path2D,[f,p,x,g]=[NaN,NaN,NaN,NaN],[m,v]=[-1/0,1/0],A=!1;for(let S of tS(o,a,e,n,(c-l)/(s.width/(1.5*devicePixelRatio)))){let C=a[S],E=s.left+(o[S]-l)*h,_=C==null?NaN:u(C);if(!Number.isFinite(_)){A&&d.lineTo(x,g),A=!1;continue}if(!A)d.moveTo(E,_),[f,p,m,v,A]=[E,_,-1/0,1/0,!0];else{let T=(_-p)/(E-f);(T<m||T>v)&&(d.lineTo(x,g),[f,p,m,v]=[x,g,-1/0,1/0]),m=Math.max(m,(_-.3-p)/(E-f)),v=Math.min(v,(_+.3-p)/(E-f))}[x,g]=[E,_]}return A&&d.lineTo(x,g),{stroke:d,flags:1}}function tS(i,t,e,n,s){let r=(i[n]-i[e])/(n-e)<s/3,o=[];for(let a=e;a<=n;){let l=i[a]+s,[c,h]=[a,a],u=a++;for(;r&&a<=n&&i[a]<l;a++)t[a]<t[c]&&(c=a),t[a]>t[h]&&(h=a);c===h?o.push(u):o.push(Math.min(c,h),Math.max(c,h))}return o}function eS(i){let{bbox:t,scales:e}=i,{min:n,max:s,distr:r}=e.y,o=t.top+t.height;if(r===3){let l=t.height/Math.log10(s/n);return c=>o-Math.log10(c/n)*l}let a=t.height/(s-n);return l=>o-(l-n)*a}function v0(i,t){let e=new Path2D,[n,s]=[i[0],t[0]],[r,o,a]=[0,0,0];e.moveTo(n,s);for(let l=1;l<i.length;l++){let[c,h]=[i[l]-n,t[l]-s],u=Math.hypot(c,h);if(a===0){u>2*.3&&([r,o,a]=[c/u,h/u,u]);continue}let d=c*r+h*o;if(Math.abs(c*o-h*r)<.3&&d>a-.3){a=Math.max(a,d);continue}[n,s,a]=[i[l-1],t[l-1],0],e.lineTo(n,s),l--}return e.lineTo(i[i.length-1],t[t.length-1]),e}function b0(i,t){let e=n=>{let{left:s,width:r}=i.getBoundingClientRect();t(Math.min(Math.max(n.clientX-s,0),r))};i.addEventListener("pointerdown",n=>{n.button===0&&(i.setPointerCapture(n.pointerId),e(n))}),i.addEventListener("pointermove",n=>{i.hasPointerCapture(n.pointerId)&&e(n)})}function rs(i,t=.07){let[e,n]=[1/0,-1/0];for(let r of i)for(let o=0;o<r.length;o++){let a=r[o];a<e&&a>-1/0&&(e=a),a>n&&a<1/0&&(n=a)}if(e>n)return[-1,1];let s=t*(n-e)||Math.abs(n)*.5||1;return[e-s,n+s]}function S0(i){let[t,e]=[1/0,0];for(let s of i)for(let r of s)r>0&&r<t&&(t=r),r>e&&r<1/0&&(e=r);if(e===0)return[.1,10];let n=Math.max(1.6,Math.sqrt(10*t/e));return[t/n,e*n]}var nS=10;function M0(i,t){let[e,n]=[Math.floor(Math.log10(i)),Math.ceil(Math.log10(t))],s=n-e>nS?[1]:[1,2,3,4,5,6,7,8,9],r=[];for(let o=e;o<=n;o++)for(let a of s){let l=+`${a}e${o}`;l>=i&&l<=t&&r.push(l)}return r}var w0='11px system-ui, -apple-system, "Segoe UI", sans-serif',iS=120,sS=[1,2,5,10,20,50,100,200,500,1e3],Ks={dash:[4,3],width:1,alpha:.65},ti=class{legend=new pc;host;#t;#e=it("div",{class:"time-cursor",hidden:!0});#n=it("div",{class:"dot",hidden:!0});#s;#i=null;#o=[];#r="";#a={x:[0,1],y:[0,1]};#l=null;#h=null;#c=!1;#u=0;constructor(t,e){this.host=t,this.#t=e,e.dot&&(this.#n.style.background=`var(--${e.dot})`),t.style.minHeight=`${e.height}px`,this.#s=new ResizeObserver(()=>{let n=Math.floor(t.clientWidth);this.#i&&n>0&&n!==this.#i.width&&this.#i.setSize({width:n,height:e.height})}),this.#s.observe(t)}draw(t,e,n){this.#o=e,this.#a=n;let s=[t,...e.map(a=>a.values)],r=JSON.stringify(e.map(({values:a,...l})=>l));(!this.#i||r!==this.#r)&&(this.#r=r,this.#i=this.#m(s));let o=this.#i;o.batch(()=>{o.setData(s,!1),o.setScale("x",{min:n.x[0],max:n.x[1]}),o.setScale("y",{min:n.y[0],max:n.y[1]})}),this.#f()}cursor(t){if(this.#l=t,!this.#i)return;let e=t===null||t<this.#a.x[0]||t>this.#a.x[1];this.#e.hidden=e,!e&&(this.#e.style.transform=`translateX(${this.#i.valToPos(t,"x")}px)`,this.#c||(this.#u||=window.setTimeout(()=>this.#f(),iS)))}point(t){this.#h=t,this.#n.hidden=!t,t&&this.#i&&(this.#n.style.transform=`translate(${this.#i.valToPos(t[0],"x")}px, ${this.#i.valToPos(t[1],"y")}px)`)}repaint(){this.#i?.redraw(!1,!1)}destroy(){this.#s.disconnect(),clearTimeout(this.#u),this.#i?.destroy()}#f(){clearTimeout(this.#u),this.#u=0,this.#i&&!this.#c&&this.#p(this.#l===null?null:this.#i.valToIdx(this.#l))}#p(t){this.legend.say(this.#o.map(e=>t==null||!e.says?"":e.says(e.values[t]??NaN)))}#m(t){this.#i?.destroy(),this.legend.list(this.#o);let{look:e,height:n,whole:s,seek:r}=this.#t,o={stroke:()=>e.colour("line"),width:1},a={stroke:()=>e.colour("faint"),font:w0,labelFont:w0,grid:o,ticks:{...o,size:4},gap:4},l=new Dn({width:Math.max(80,Math.floor(this.host.clientWidth)),height:n,padding:[8,10,0,0],legend:{show:!1},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:6},bind:{dblclick:()=>null}},scales:{x:{time:!1,auto:!1,min:this.#a.x[0],max:this.#a.x[1]},y:{auto:!1,distr:this.#t.log?3:1,min:this.#a.y[0],max:this.#a.y[1]}},axes:[{...a,label:this.#t.xTitle,labelSize:16,size:26,values:(c,h)=>Td(h,this.#a.xFactor??1),...s?{incrs:sS}:{}},{...a,size:52,space:28,...this.#t.log?{splits:(c,h,u,d)=>M0(u,d),filter:(c,h)=>h,grid:{...o,filter:(c,h)=>Vm(h)}}:{},values:(c,h)=>this.#t.log?Wm(h):Td(h,this.#a.factor??1)}],series:[{},...this.#o.map(c=>this.#g(c))],hooks:{drawClear:[c=>this.#t.under?.(c)],draw:[c=>this.#y(c)],setCursor:[c=>this.#d(c)]}},t,this.host);return l.over.append(this.#e,this.#n),r&&b0(l.over,c=>r(l.posToVal(c,"x"))),l}#g(t){return{stroke:()=>this.#t.look.colour(t.token),width:t.width??1.4,dash:t.dash??[],alpha:t.alpha??1,paths:x0,points:{show:!1}}}#y(t){for(let e of this.#o)e.marker&&y0(t,e,this.#t.look.colour(e.token),this.#t.look.colour("card"));this.#t.over?.(t),this.cursor(this.#l),this.point(this.#h)}#d(t){let{idx:e,left:n=-1,top:s=-1}=t.cursor,r=e!=null;!r&&!this.#c||(this.#c=r,this.#t.hover?.(r?[t.posToVal(n,"x"),t.posToVal(s,"y")]:null),r?this.#p(e):this.#f())}};function Rr(i){return i.span==="trial"?i.trial:null}function Ei(i){return i.span==="trial"?i.time:i.trial*i.run.picture.duration+i.time}function Hi(i){let{duration:t,trials:e}=i.run.picture;return i.span==="trial"?t:t*Math.max(1,e,i.pinned?.run.picture.trials??0)}function Sa(i,t){return i.run.ports.findIndex(({name:e,motion_unit:n})=>e===t.name&&n===t.motion_unit)}function _o(i,t,e,n){let{pinned:s}=i;if(!s||!s.run.hasSignal(t))return null;let r=e?Sa(s,e):0,o=Rr(i);return r<0||o!==null&&o>=s.run.picture.trials?null:rS(n,s.run.curve(t,r,o))}function rS(i,t){let[e,n]=[i.time,t.time],s=n.length-1;if(e.length===n.length&&e[s]===n[s])return t.values;let r=new Float32Array(e.length).fill(NaN);for(let o=0,a=0;o<e.length&&e[o]<=n[s];o++){for(;a<s-1&&n[a+1]<e[o];)a++;let l=s>0?(e[o]-n[a])/(n[a+1]-n[a]):0,c=t.values[a];r[o]=s>0?c+l*(t.values[a+1]-c):c}return r}var oS=0,ei=class{root;body=it("div",{class:"card-body"});#t=it("span",{});#e=it("span",{class:"card-unit"});#n=it("p",{class:"card-caption"});constructor(...t){let e=`card-${++oS}`,n=it("h3",{id:e},this.#t," ",this.#e);this.root=it("article",{class:"card",attributes:{"aria-labelledby":e}},n,this.#n,...t,this.body)}title(t,e){rn(this.#t,t),rn(this.#e,e)}caption(t){rn(this.#n,t)}};var mc=class{card;#t;#e=Mi();#n;#s=0;#i=1;constructor(t,e){this.#n=e,this.#t=new ti(this.#e,{look:t.look,height:170,xTitle:"time t [s]",seek:t.seek,under:n=>ro(n,t.look,this.#s,this.#i)}),this.card=new ei(this.#t.legend.root),this.card.body.append(this.#e)}draw(t){let{run:e}=t,n=e.ports[this.#n],{token:s}=is(e.ports,this.#n),r=Rr(t),o=e.curve("delivered",this.#n,r),a=e.curve("command",this.#n,r),l=_o(t,"delivered",n,o),c=e.largest("delivered",this.#n,r),h=e.largest("command",this.#n,r),u=new Je(Math.max(c,h)||1,n.effort_unit),d=x=>u.text(x);this.#s=r===null?e.picture.trials:0,this.#i=e.picture.duration;let f=[];l&&f.push({label:`${t.pinned.label}, delivered`,token:s,values:l,...Ks,says:d}),f.push({label:"command",token:"faint",values:a.values,dash:[5,3],width:1,says:d}),f.push({label:"delivered",token:s,values:o.values,says:d}),this.#t.draw(o.time,f,{x:[0,Hi(t)],y:rs(f.map(({values:x})=>x)),factor:u.factor}),this.card.title(Ui($s(n)),`[${u.unit}]`);let p=`Largest ${u.text(h)} commanded, ${u.text(c)} delivered ${r===null?"in all trials":`in trial ${r}`}.`;this.card.caption(p),Qn(this.#e,`${Ui($s(n))} against time. ${p}`)}cursor(t){this.#t.cursor(Ei(t))}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}};var T0=[["initial","at the start"],["law","by the control law"],["actuator","by the actuators' error"],["disturbance","by disturbances"],["load","by the distributed load"],["dissipated","damped away"],["resets","by the resets between trials"],["final","at the end"]],E0=new Set(["initial","law","final"]),aS=new Set(["dissipated"]),gc=class{root=it("details",{class:"account",open:!0},it("summary",{},"Account of the whole run"));#t=it("tbody",{});#e=it("p",{class:"account-closing"});constructor(){this.root.append(it("table",{},it("caption",{class:"unseen"},"Energy account"),this.#t),this.#e)}fill(t,e){let n=Math.max(...T0.map(([l])=>Math.abs(t[l]??0))),s=new Je(n,"J"),r=(l,c)=>{let h=(aS.has(c)?-1:1)*(l[c]??0);return E0.has(c)&&(c==="initial"||c==="final")?s.text(h):`${h>0?"+":""}${s.text(h)}`},o=T0.filter(([l])=>E0.has(l)||t[l]||e?.run.picture.energy[l]);this.#t.replaceChildren(...e?[it("tr",{},it("td",{}),it("th",{scope:"col"},"now"),it("th",{scope:"col"},e.label))]:[],...o.map(([l,c])=>it("tr",{class:l==="final"?"total":""},it("th",{scope:"row"},c),it("td",{},r(t,l)),...e?[it("td",{},r(e.run.picture.energy,l))]:[])));let a=t.error;this.#e.textContent=a===void 0?"":`The account closes to ${Oi(a,2)} of the largest energy.`}};var _c=class{card;#t;#e=Mi();#n=new gc;#s=0;#i=1;constructor(t){this.#t=new ti(this.#e,{look:t.look,height:160,xTitle:"time t [s]",seek:t.seek,under:e=>ro(e,t.look,this.#s,this.#i)}),this.card=new ei(this.#t.legend.root),this.card.body.append(this.#e,this.#n.root)}draw(t){let{run:e}=t,n=Rr(t),s=e.curve("energy",0,n),r=_o(t,"energy",null,s),o=e.largest("energy",0,n),a=new Je(o||1,"J"),l=f=>a.text(f);this.#s=n===null?e.picture.trials:0,this.#i=e.picture.duration;let c=[];r&&c.push({label:t.pinned.label,token:"ink",values:r,...Ks,says:l}),c.push({label:r?"structure, now":"structure",token:"ink",values:s.values,says:l});let h=n===null?null:e.trial(n);h&&c.push({label:"barrier",token:"constraint",values:h.column("barrier",0),dash:[6,4],says:l});let[,u]=rs(c.map(({values:f})=>f));this.#t.draw(s.time,c,{x:[0,Hi(t)],y:[-.04*u,u],factor:a.factor}),this.#n.fill(e.picture.energy,t.pinned),this.card.title("Energy",`[${a.unit}]`);let d=`Largest ${a.text(o)} ${n===null?"in all trials":`in trial ${n}`}.`;this.card.caption(d),Qn(this.#e,`Energy of the structure against time. ${d}`)}cursor(t){this.#t.cursor(Ei(t))}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}};var lS=new Float32Array(2).fill(NaN),yc=class{card;#t;#e=Mi();#n;#s;#i;#o=null;#r=null;#a=1;#l="";constructor(t,e,n){this.#n=t.look,this.#s=n,this.#i=is(e,n).token,this.#t=new ti(this.#e,{look:t.look,height:290,dot:this.#i,xTitle:()=>`command [${this.#l}]`,over:s=>this.#h(s)}),this.card=new ei(this.#t.legend.root),this.card.body.append(this.#e)}draw(t){let{run:e,pinned:n,trial:s}=t,r=e.ports[this.#s];this.#a=e.picture.gains[this.#s]??1;let o=e.trial(s);this.#o=o&&{command:o.column("command",this.#s),delivered:o.column("delivered",this.#s)};let a=n?Sa(n,r):-1,l=a>=0?n?.run.trial(s):null;this.#r=l?{command:l.column("command",a),delivered:l.column("delivered",a)}:null;let c=[this.#o,this.#r].filter(x=>x!==null),h=rs(c.map(({command:x})=>x)),u=rs(c.map(({delivered:x})=>x)),d=new Je(Math.max(-h[0],h[1],-u[0],u[1]),r.effort_unit);this.#l=d.unit;let f=[{label:`gain ${Oi(this.#a)}`,token:"faint",dash:[5,3],width:1},...this.#r?[{label:n.label,token:this.#i,dash:[4,3],width:1,alpha:.65}]:[],{label:this.#r?"now":"delivered",token:this.#i}];this.#t.draw(Float64Array.of(...h),f.map(x=>({...x,values:lS})),{x:h,y:u,factor:d.factor,xFactor:d.factor}),this.card.title(`${Ui($s(r))} loop`,`delivered [${d.unit}]`);let p=o?`Trial ${s}: ${cS(this.#o,this.#a,r.effort_unit)}.`:`Trial ${s} is on its way.`;this.card.caption(p),Qn(this.#e,`Delivered against commanded ${$s(r)}. ${p}`)}cursor(t){let e=t.run.trial(t.trial);this.#t.point(e&&[e.at("command",this.#s,t.time),e.at("delivered",this.#s,t.time)])}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}#h(t){let{ctx:e,bbox:n}=t,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(n.left,n.top,n.width,n.height),e.clip();let[r,o]=[t.scales.x.min,t.scales.x.max];of(t,{command:Float32Array.of(r,o),delivered:Float32Array.of(r*this.#a,o*this.#a)},this.#n.colour("faint"),s,[5*s,3*s]),e.globalAlpha=.65,this.#r&&of(t,this.#r,this.#n.colour(this.#i),s,[4*s,3*s]),e.globalAlpha=1,this.#o&&of(t,this.#o,this.#n.colour(this.#i),1.4*s,[]),e.restore()}};function of(i,{command:t,delivered:e},n,s,r){let{ctx:o}=i,a=t.map(c=>i.valToPos(c,"x",!0)),l=e.map(c=>i.valToPos(c,"y",!0));o.strokeStyle=n,o.lineWidth=s,o.setLineDash(r),o.stroke(v0(a,l))}function cS({command:i,delivered:t},e,n){let s=0;for(let r=0;r<i.length;r++)s=Math.max(s,Math.abs(t[r]-e*i[r]));return`up to ${new Je(s,n).text(s)} off the line of gain ${Oi(e)}`}var hS=1.7,xc=class{card;#t;#e=Mi();#n;#s;#i={low:null,high:null};#o=0;#r=1;constructor(t,e){this.#n=t,this.#s=e,this.#t=new ti(this.#e,{look:t.look,height:190,xTitle:"time t [s]",seek:t.seek,under:n=>this.#h(n)}),this.card=new ei(this.#t.legend.root),this.card.body.append(this.#e)}draw(t){let{run:e}=t,n=e.ports[this.#s],s=is(e.ports,this.#s),r=Rr(t),o=e.curve("y",this.#s,r),a=_o(t,"y",n,o),l=e.largest("y",this.#s,r),c=new Je(l||1,n.motion_unit),h=f=>c.text(f);this.#i=this.#a(e,r,Math.max(l,a?rs([a])[1]:0)),this.#o=r===null?e.picture.trials:0,this.#r=e.picture.duration;let u=[];a&&u.push({label:t.pinned.label,token:s.token,values:a,...Ks,says:h}),e.picture.tracking&&u.push({label:"reference",token:"reference",values:e.curve("reference",this.#s,r).values,dash:[1.5,2.5],says:h});for(let[f,p]of Object.entries(this.#i)){let x=f==="high"&&this.#i.low!==null;p&&u.push({label:"constraint",token:"constraint",values:p.values,dash:[6,4],width:1.2,unlisted:x})}u.push({label:a?"now":fa(n),token:s.token,values:o.values,dash:s.dash,says:h}),this.#t.draw(o.time,u,{x:[0,Hi(t)],y:rs(u.map(({values:f})=>f)),factor:c.factor}),this.card.title(Ui(Ys(n)),`${fa(n)} [${c.unit}]`);let d=this.#l(t,n,c);this.card.caption(d),Qn(this.#e,`${Ui(Ys(n))} against time. ${d}`)}cursor(t){this.#t.cursor(Ei(t))}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}#a(t,e,n){let s=r=>{let o=t.curve(r,this.#s,e);return o.values.reduce((l,c)=>Math.min(l,Math.abs(c)),1/0)<hS*n?o:null};return{low:s("low"),high:s("high")}}#l({run:t,trial:e,span:n},s,r){let o=n==="trial"?e:null,a=`Largest ${r.text(t.largest("y",this.#s,o))} ${n==="trial"?`in trial ${e}`:"in all trials"}`,l=["low","high"].map(f=>t.curve(f,this.#s,o).values),[c,h]=l.map(f=>f[0]);if(c===-1/0&&h===1/0)return`${a}; no constraint.`;if(l.some(f=>f.some(p=>p!==f[0])))return`${a}; the constraint moves.`;let u=new Je(Math.max(...[c,h].map(Math.abs).filter(Number.isFinite)),s.motion_unit),d=c===-h?`±${u.text(h)}`:`${u.number(c)} … ${u.text(h)}`;return`${a}; constraint ${d}${this.#i.low||this.#i.high?"":" (beyond the plot)"}.`}#h(t){this.#i.high&&Ed(t,this.#n.look,this.#i.high,1),this.#i.low&&Ed(t,this.#n.look,this.#i.low,-1),ro(t,this.#n.look,this.#o,this.#r)}};var vc=class{root=it("div",{class:"unseen"});#t=[];#e="";fill(t){let{trials:e,ports:n}=t.picture,s=[e,...n.map(({name:r})=>r)].join();s!==this.#e&&(this.#e=s,this.#n(t)),this.#t.forEach((r,o)=>{let a=t.peaks[o];r.dataset.value=String(a),rn(r,pa(a,n[o%n.length].motion_unit))})}#n({picture:{trials:t,ports:e}}){this.#t=[];let n=it("tr",{},it("th",{scope:"col"},"Trial"),...e.map(o=>it("th",{scope:"col"},`Largest ${Ys(o)}`))),s=Array.from({length:t},(o,a)=>{let l=e.map(c=>it("td",{attributes:{"data-port":c.name,"data-trial":String(a)}}));return this.#t.push(...l),it("tr",{},it("th",{scope:"row"},String(a)),...l)}),r=it("caption",{},"Peaks of every trial");this.root.replaceChildren(it("table",{attributes:{"data-role":"peaks"}},r,it("thead",{},n),it("tbody",{},...s)))}};var bc=class{card;#t;#e=Mi();#n=new vc;constructor(t){this.#t=new ti(this.#e,{look:t.look,height:190,xTitle:"trial",log:!0,whole:!0,seek:e=>t.jump(Math.round(e))}),this.card=new ei(this.#t.legend.root),this.card.body.append(this.#e,this.#n.root)}draw({run:t,pinned:e}){let{trials:n}=t.picture,s=Math.max(n,e?.run.picture.trials??0),r=[];t.ports.forEach((h,u)=>{let d=is(t.ports,u),f=g=>pa(g,h.motion_unit),p=e?Sa(e,h):-1;if(e&&p>=0){let g=Float64Array.from({length:s},(m,v)=>e.run.peak(v,p));r.unshift({label:e.label,token:d.token,values:g,...Ks,marker:d.marker,unlisted:u>0})}let x=Float64Array.from({length:s},(g,m)=>t.peak(m,u));r.push({label:Ys(h),token:d.token,values:x,marker:d.marker,says:f})});let o=Float64Array.from({length:s},(h,u)=>u);this.#t.draw(o,r,{x:[-.5,s-.5],y:S0(r.map(({values:h})=>h))}),this.#n.fill(t);let a=[...new Set(t.ports.map(({motion_unit:h})=>`[${h}]`))].join(", ");this.card.title(t.picture.tracking?"Largest tracking error of each trial":"Peak of each trial",a);let l=(h,u)=>`${pa(t.peak(h,u),t.ports[u].motion_unit)} in trial ${h}`,c=t.ports.map((h,u)=>`${Ys(h)} ${l(0,u)}, ${l(n-1,u)}`);this.card.caption(n>0?`${Ui(c[0]??"")}.`:"No trial has been finished."),Qn(this.#e,`Peaks on a logarithmic axis against trials. ${c.map(Ui).join(". ")}.`)}cursor({trial:t}){this.#t.cursor(t)}repaint(){this.#t.repaint()}destroy(){this.#t.destroy()}};var Sc=class{root;#t=it("canvas",{width:256,height:1});#e=this.#t.getContext("2d");#n=new ImageData(256,1);#s=it("span",{});#i=it("span",{});constructor(){this.root=it("div",{class:"colour-bar",attributes:{"aria-hidden":"true"}},this.#s,this.#t,this.#i)}draw(t,e,n){new Uint32Array(this.#n.data.buffer).set(n),this.#e?.putImageData(this.#n,0,0),rn(this.#s,e.number(-t)),rn(this.#i,`+${e.text(t)}`)}};var uS=[[5,48,97],[33,102,172],[67,147,195],[146,197,222],[209,229,240],[247,247,247],[253,219,199],[244,165,130],[214,96,77],[178,24,43],[103,0,31]],dS=[[166,216,250],[110,182,235],[66,142,204],[42,98,148],[31,58,86],[29,33,37],[84,46,38],[148,66,50],[206,96,74],[240,144,118],[255,200,180]],Ma=256;function af(i){let t=i?dS:uS;return Uint32Array.from({length:Ma},(e,n)=>{let s=n/(Ma-1)*(t.length-1),r=Math.min(Math.floor(s),t.length-2),[o,a]=[t[r],t[r+1]],[l,c,h]=o.map((u,d)=>Math.round(u+(s-r)*(a[d]-u)));return 255<<24|h<<16|c<<8|l})}function A0(i,t,e,n){let{width:s,height:r}=i,o=new Uint32Array(i.data.buffer),a=e>0?(Ma-1)/(2*e):0;for(let l=0;l<s;l++)for(let c=0;c<r;c++){let h=(t[l*r+c]+e)*a;o[(r-1-c)*s+l]=n[h<0?0:h>Ma-1?Ma-1:h|0]}}var fS=new Float32Array(2).fill(NaN),wa=class{root=Mi();#t;#e=document.createElement("canvas");#n=this.#e.getContext("2d");#s=null;#i=1;#o=null;constructor(t,e,n,s){this.#t=new ti(this.root,{look:t,height:e,xTitle:"time t [s]",seek:n,under:r=>this.#a(r),hover:r=>this.#r(r,s)})}draw(t,e,n,s,r,o){if(t.rows===0)return;let a=t.values.length/t.rows;(!this.#o||this.#o.width!==t.rows||this.#o.height!==a)&&(this.#e.width=t.rows,this.#e.height=a,this.#o=new ImageData(t.rows,a)),A0(this.#o,t.values,s,r),this.#n?.putImageData(this.#o,0,0),this.#s=t,this.#i=e,this.#t.draw(Float64Array.of(0,n),[{label:"",token:"ink",values:fS}],{x:[0,n],y:[0,e]}),Qn(this.root,o)}cursor(t){this.#t.cursor(t)}destroy(){this.#t.destroy()}#r(t,e){if(!t||!this.#s)return e(NaN,NaN,NaN);let[n,s]=t,{values:r,rows:o,end:a}=this.#s,l=r.length/o,c=Math.min(Math.floor(n/a*o),o-1),h=Math.min(Math.max(Math.round(s/this.#i*(l-1)),0),l-1);e(r[c*l+h]??NaN,n,s)}#a(t){if(!this.#s)return;let{ctx:e,bbox:n}=t,s=t.valToPos(this.#s.end,"x",!0);e.imageSmoothingEnabled=!0,e.drawImage(this.#e,n.left,n.top,s-n.left,n.height)}};var Mc=class{card;#t;#e=new Sc;#n=it("select",{attributes:{"aria-label":"Field to be seen"}});#s;#i;#o=it("p",{class:"card-note"});#r=null;#a="";#l="";#h=new Je(1,"");#c;constructor(t,e){this.#t=t,this.#c=af(t.look.dark);let n=(s,r,o)=>this.#u(s,r,o);this.#s=new wa(t.look,170,t.seek,n),this.#i=new wa(t.look,150,t.seek,n),this.#n.append(...e.map(({name:s})=>it("option",{value:s},`${Yn(s)}(x, t)`))),this.#n.onchange=()=>this.#r&&(this.draw(this.#r),this.cursor(this.#r)),this.card=new ei(it("div",{class:"card-tools"},...e.length>1?[this.#n]:[],this.#e.root)),this.card.body.append(this.#s.root,this.#o,this.#i.root)}draw(t){this.#r=t;let{run:e,pinned:n,trial:s,span:r}=t,{name:o,unit:a}=e.picture.fields.find(p=>p.name===this.#n.value)??e.picture.fields[0],l=n?.run.picture.fields.some(p=>p.name===o)?n:null,c=r==="trial"?s:null,h=Math.max(e.largestOfField(o,c),l?.run.largestOfField(o,c)??0),u=new Je(h||1,a),d=`${Yn(o)}(x, t) ${c===null?"in all trials":`in trial ${s}`}`,f=`Largest ${u.text(e.largestOfField(o,c))} ${c===null?"in all trials":`in trial ${s}`}`;if(this.#e.draw(h,u,this.#c),this.#s.draw(R0(e,o,c),e.picture.span,Hi(t),h,this.#c,`${d} as a map of time and place. ${f}.`),this.#i.root.hidden=this.#o.hidden=!l,l){this.#o.textContent=`${l.label}, same colours`;let p=R0(l.run,o,c);this.#i.draw(p,l.run.picture.span,Hi(t),h,this.#c,`${d} of ${l.label}.`)}this.card.title(`Shape ${Yn(o)}(x, t) over place x [m] and time`,`[${u.unit}]`),[this.#a,this.#l,this.#h]=[`${f}.`,Yn(o),u],this.card.caption(this.#a)}#u(t,e,n){let s=`${this.#l} = ${this.#h.text(t)} at x = ${Oi(n)} m, t = ${Oi(e)} s`;this.card.caption(Number.isNaN(t)?this.#a:s)}cursor(t){this.#s.cursor(Ei(t)),t.pinned&&this.#i.cursor(Ei(t))}repaint(){this.#c=af(this.#t.look.dark),this.#r&&this.draw(this.#r)}destroy(){this.#s.destroy(),this.#i.destroy()}};function R0(i,t,e){let{duration:n,trials:s}=i.picture,r=e===null?null:i.trial(e);if(r)return{values:r.field(t),rows:r.snapshots,end:n};let{values:o,rows:a,perTrial:l}=i.field(t);if(e===null)return{values:o,rows:a,end:n*s};let c=l*i.x.length;return{values:o.subarray(e*c,(e+1)*c),rows:l,end:n}}var wc=class{#t;#e;#n;#s=[];#i="";#o=null;constructor(t,e){this.#t=t,this.#e=e,this.#t.classList.add("panels"),this.#n=new IntersectionObserver(n=>this.#l(n),{rootMargin:"80px"})}draw(t){this.#o=t,this.#a(t.run);for(let e of this.#s)e.stale=!0,this.#r(e)}cursor(t){this.#o=t;for(let{panel:e,seen:n,stale:s}of this.#s)n&&!s&&e.cursor(t)}repaint(){for(let{panel:t}of this.#s)t.repaint()}#r(t){!t.seen||!t.stale||!this.#o||(t.stale=!1,t.panel.draw(this.#o),t.panel.cursor(this.#o))}#a({picture:{ports:t,fields:e,gains:n}}){let s=c=>n[c]!==0,r=JSON.stringify([t,e,t.map((c,h)=>s(h))]);if(r===this.#i)return;this.#i=r;for(let{panel:c}of this.#s)c.destroy();this.#n.disconnect();let o=t.map((c,h)=>h),a=o.filter(s),l=[new bc(this.#e),...o.map(c=>new xc(this.#e,c)),...a.map(c=>new mc(this.#e,c)),...e.length>0?[new Mc(this.#e,e)]:[],...a.map(c=>new yc(this.#e,t,c)),new _c(this.#e)];this.#s=l.map(c=>({panel:c,seen:!0,stale:!0})),this.#t.replaceChildren(...l.map(({card:c})=>c.root));for(let c of l)this.#n.observe(c.card.root)}#l(t){for(let{target:e,isIntersecting:n}of t){let s=this.#s.find(({panel:r})=>r.card.root===e);s&&(s.seen=n,this.#r(s),s.seen&&this.#o&&s.panel.cursor(this.#o))}}};function C0(i){document.addEventListener("keydown",t=>{let e=i[t.key];!e||t.ctrlKey||t.altKey||t.metaKey||t.defaultPrevented||pS(t.target)||t.key===" "&&mS(t.target)||(t.preventDefault(),e())})}function pS(i){return i instanceof HTMLInputElement?!["range","checkbox","radio","button"].includes(i.type):i instanceof HTMLTextAreaElement||i instanceof HTMLSelectElement||i instanceof HTMLElement&&i.isContentEditable}function mS(i){return i instanceof Element&&i.closest("button, summary, a, [type=checkbox], [type=radio]")!==null}var cr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},a_=0,zf=1,l_=2;var rl=1,c_=2,Wo=3,ur=0,Kn=1,us=2,Ur=0,Xo=1,Hf=2,Vf=3,Gf=4,h_=5;var Or=100,u_=101,d_=102,f_=103,p_=104,m_=200,g_=201,__=202,y_=203,Wf=204,Xf=205,x_=206,v_=207,b_=208,S_=209,M_=210,w_=211,T_=212,E_=213,A_=214,jc=0,Qc=1,th=2,Do=3,eh=4,nh=5,ih=6,sh=7,Oh=0,R_=1,C_=2,ds=0,qf=1,Yf=2,$f=3,Zf=4,Jf=5,Kf=6,jf=7;var Qf=300,kr=301,qo=302,kh=303,Bh=304,rh=1e3,as=1001,oh=1002,Pn=1003,P_=1004;var ol=1005;var Jn=1006,zh=1007;var Us=1008;var ii=1009,tp=1010,ep=1011,Yo=1012,Hh=1013,qi=1014,Yi=1015,$i=1016,Vh=1017,Gh=1018,Br=1020,np=35902,ip=35899,sp=1021,rp=1022,Zi=1023,Ps=1026,Os=1027,op=1028,Wh=1029,dr=1030,Xh=1031;var qh=1033,al=33776,ll=33777,cl=33778,hl=33779,Yh=35840,$h=35841,Zh=35842,Jh=35843,Kh=36196,jh=37492,Qh=37496,tu=37488,eu=37489,ul=37490,nu=37491,iu=37808,su=37809,ru=37810,ou=37811,au=37812,lu=37813,cu=37814,hu=37815,uu=37816,du=37817,fu=37818,pu=37819,mu=37820,gu=37821,_u=36492,yu=36494,xu=36495,vu=36283,bu=36284,dl=36285,Su=36286;var Na=2300,ah=2301,Jc=2302,Df=2303,Nf=2400,Ff=2401,Uf=2402;var I_=3200;var Mu=0,L_=1,ks="",mi="srgb",Fa="srgb-linear",Ua="linear",Ee="srgb";var Kc=7680;var D_=519,N_=512,F_=513,U_=514,ap=515,O_=516,k_=517,lp=518,cp=519,B_=35044,hp=35048;var up="300 es",Ri=2e3,No=2001;function gS(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function _S(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Oa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function z_(){let i=Oa("canvas");return i.style.display="block",i}var P0={},Fo=null;function dp(...i){let t="THREE."+i.shift();Fo?Fo("log",t,...i):console.log(t,...i)}function H_(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $t(...i){i=H_(i);let t="THREE."+i.shift();if(Fo)Fo("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function te(...i){i=H_(i);let t="THREE."+i.shift();if(Fo)Fo("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Pa(...i){let t=i.join(" ");t in P0||(P0[t]=!0,$t(...i))}function V_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var G_={[jc]:jc,[th]:ih,[eh]:eh,[Do]:nh,[Qc]:Qc,[ih]:th,[sh]:sh,[nh]:Do},Xi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Bn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],I0=1234567,Io=Math.PI/180,Uo=180/Math.PI;function $o(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Bn[i&255]+Bn[i>>8&255]+Bn[i>>16&255]+Bn[i>>24&255]+"-"+Bn[t&255]+Bn[t>>8&255]+"-"+Bn[t>>16&15|64]+Bn[t>>24&255]+"-"+Bn[e&63|128]+Bn[e>>8&255]+"-"+Bn[e>>16&255]+Bn[e>>24&255]+Bn[n&255]+Bn[n>>8&255]+Bn[n>>16&255]+Bn[n>>24&255]).toLowerCase()}function ce(i,t,e){return Math.max(t,Math.min(e,i))}function fp(i,t){return(i%t+t)%t}function yS(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function xS(i,t,e){return i!==t?(e-i)/(t-i):0}function Ia(i,t,e){return(1-e)*i+e*t}function vS(i,t,e,n){return Ia(i,t,1-Math.exp(-e*n))}function bS(i,t=1){return t-Math.abs(fp(i,t*2)-t)}function SS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function MS(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function wS(i,t){return i+Math.floor(Math.random()*(t-i+1))}function TS(i,t){return i+Math.random()*(t-i)}function ES(i){return i*(.5-Math.random())}function AS(i){i!==void 0&&(I0=i);let t=I0+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function RS(i){return i*Io}function CS(i){return i*Uo}function PS(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function IS(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function pp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function LS(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*p,l*f,a*c);break;case"YXY":i.set(l*f,a*h,l*p,a*c);break;case"ZYZ":i.set(l*p,l*f,a*h,a*c);break;default:$t("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function mp(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function W_(i,t){if(t.constructor===Float32Array)return i;let e=mp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function X_(i,t){if(t.constructor===Float32Array)return i;let e=mp(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var gp={DEG2RAD:Io,RAD2DEG:Uo,generateUUID:$o,clamp:ce,euclideanModulo:fp,mapLinear:yS,inverseLerp:xS,lerp:Ia,damp:vS,pingpong:bS,smoothstep:SS,smootherstep:MS,randInt:wS,randFloat:TS,randFloatSpread:ES,seededRandom:AS,degToRad:RS,radToDeg:CS,isPowerOfTwo:PS,ceilPowerOfTwo:IS,floorPowerOfTwo:pp,setQuaternionFromProperEuler:LS,normalize:X_,denormalize:W_},kt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},_i=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==f||h!==p){let g=l*d+c*f+h*p+u*x;g<0&&(d=-d,f=-f,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let v=Math.acos(g),A=Math.sin(v);m=Math.sin(m*v)/A,a=Math.sin(a*v)/A,l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a}else{l=l*m+d*a,c=c*m+f*a,h=h*m+p*a,u=u*m+x*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*f-c*d,t[e+1]=l*p+h*d+c*u-a*f,t[e+2]=c*p+h*f+a*d-l*u,t[e+3]=h*p-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u+d*f*p;break;case"YZX":this._x=d*h*u+c*f*p,this._y=c*f*u+d*h*p,this._z=c*h*p-d*f*u,this._w=c*h*u-d*f*p;break;case"XZY":this._x=d*h*u-c*f*p,this._y=c*f*u-d*h*p,this._z=c*h*p+d*f*u,this._w=c*h*u+d*f*p;break;default:$t("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(L0.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(L0.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return lf.copy(this).projectOnVector(t),this.sub(lf)}reflect(t){return this.sub(lf.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(ce(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},lf=new B,L0=new _i,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],g=s[3],m=s[6],v=s[1],A=s[4],S=s[7],C=s[2],E=s[5],_=s[8];return r[0]=o*x+a*v+l*C,r[3]=o*g+a*A+l*E,r[6]=o*m+a*S+l*_,r[1]=c*x+h*v+u*C,r[4]=c*g+h*A+u*E,r[7]=c*m+h*S+u*_,r[2]=d*x+f*v+p*C,r[5]=d*g+f*A+p*E,r[8]=d*m+f*S+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Pa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(cf.makeScale(t,e)),this}rotate(t){return Pa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(cf.makeRotation(-t)),this}translate(t,e){return Pa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(cf.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},cf=new ee,D0=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),N0=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function DS(){let i={enabled:!0,workingColorSpace:Fa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ee&&(s.r=Cs(s.r),s.g=Cs(s.g),s.b=Cs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ee&&(s.r=Lo(s.r),s.g=Lo(s.g),s.b=Lo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?Ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Fa]:{primaries:t,whitePoint:n,transfer:Ua,toXYZ:D0,fromXYZ:N0,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:mi},outputColorSpaceConfig:{drawingBufferColorSpace:mi}},[mi]:{primaries:t,whitePoint:n,transfer:Ee,toXYZ:D0,fromXYZ:N0,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:mi}}}),i}var ye=DS();function Cs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Lo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var yo,lh=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{yo===void 0&&(yo=Oa("canvas")),yo.width=t.width,yo.height=t.height;let s=yo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=yo}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Oa("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Cs(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Cs(e[n]/255)*255):e[n]=Cs(e[n]);return{data:e,width:t.width,height:t.height}}else return $t("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},NS=0,Oo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:NS++}),this.uuid=$o(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(hf(s[o].image)):r.push(hf(s[o]))}else r=hf(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function hf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?lh.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($t("Texture: Unable to serialize Texture."),{})}var FS=0,uf=new B,ni=class i extends Xi{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=as,s=as,r=Jn,o=Us,a=Zi,l=ii,c=i.DEFAULT_ANISOTROPY,h=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:FS++}),this.uuid=$o(),this.name="",this.source=new Oo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new kt(0,0),this.repeat=new kt(1,1),this.center=new kt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(uf).x}get height(){return this.source.getSize(uf).y}get depth(){return this.source.getSize(uf).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){$t(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Qf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case rh:t.x=t.x-Math.floor(t.x);break;case as:t.x=t.x<0?0:1;break;case oh:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case rh:t.y=t.y-Math.floor(t.y);break;case as:t.y=t.y<0?0:1;break;case oh:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ni.DEFAULT_IMAGE=null;ni.DEFAULT_MAPPING=Qf;ni.DEFAULT_ANISOTROPY=1;var $e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let A=(c+1)/2,S=(f+1)/2,C=(m+1)/2,E=(h+d)/4,_=(u+x)/4,T=(p+g)/4;return A>S&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=_/n):S>C?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=E/s,r=T/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=T/r),this.set(n,s,r,e),this}let v=Math.sqrt((g-p)*(g-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(g-p)/v,this.y=(u-x)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ce(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ch=class extends Xi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Jn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new $e(0,0,t,e),this.scissorTest=!1,this.viewport=new $e(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ni({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Jn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Oo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},yi=class extends ch{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},ka=class extends ni{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var hh=class extends ni{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Pn,this.minFilter=Pn,this.wrapR=as,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ue=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g)}set(t,e,n,s,r,o,a,l,c,h,u,d,f,p,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=d,m[3]=f,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/xo.setFromMatrixColumn(t,0).length(),r=1/xo.setFromMatrixColumn(t,1).length(),o=1/xo.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+p*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,p=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-f,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(US,t,OS)}lookAt(t,e,n){let s=this.elements;return fi.subVectors(t,e),fi.lengthSq()===0&&(fi.z=1),fi.normalize(),js.crossVectors(n,fi),js.lengthSq()===0&&(Math.abs(n.z)===1?fi.x+=1e-4:fi.z+=1e-4,fi.normalize(),js.crossVectors(n,fi)),js.normalize(),Tc.crossVectors(fi,js),s[0]=js.x,s[4]=Tc.x,s[8]=fi.x,s[1]=js.y,s[5]=Tc.y,s[9]=fi.y,s[2]=js.z,s[6]=Tc.z,s[10]=fi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],g=n[10],m=n[14],v=n[3],A=n[7],S=n[11],C=n[15],E=s[0],_=s[4],T=s[8],O=s[12],N=s[1],D=s[5],z=s[9],G=s[13],L=s[2],W=s[6],Y=s[10],V=s[14],ht=s[3],J=s[7],j=s[11],st=s[15];return r[0]=o*E+a*N+l*L+c*ht,r[4]=o*_+a*D+l*W+c*J,r[8]=o*T+a*z+l*Y+c*j,r[12]=o*O+a*G+l*V+c*st,r[1]=h*E+u*N+d*L+f*ht,r[5]=h*_+u*D+d*W+f*J,r[9]=h*T+u*z+d*Y+f*j,r[13]=h*O+u*G+d*V+f*st,r[2]=p*E+x*N+g*L+m*ht,r[6]=p*_+x*D+g*W+m*J,r[10]=p*T+x*z+g*Y+m*j,r[14]=p*O+x*G+g*V+m*st,r[3]=v*E+A*N+S*L+C*ht,r[7]=v*_+A*D+S*W+C*J,r[11]=v*T+A*z+S*Y+C*j,r[15]=v*O+A*G+S*V+C*st,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],g=t[11],m=t[15],v=l*f-c*d,A=a*f-c*u,S=a*d-l*u,C=o*f-c*h,E=o*d-l*h,_=o*u-a*h;return e*(x*v-g*A+m*S)-n*(p*v-g*C+m*E)+s*(p*A-x*C+m*_)-r*(p*S-x*E+g*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],g=t[14],m=t[15],v=e*a-n*o,A=e*l-s*o,S=e*c-r*o,C=n*l-s*a,E=n*c-r*a,_=s*c-r*l,T=h*x-u*p,O=h*g-d*p,N=h*m-f*p,D=u*g-d*x,z=u*m-f*x,G=d*m-f*g,L=v*G-A*z+S*D+C*N-E*O+_*T;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/L;return t[0]=(a*G-l*z+c*D)*W,t[1]=(s*z-n*G-r*D)*W,t[2]=(x*_-g*E+m*C)*W,t[3]=(d*E-u*_-f*C)*W,t[4]=(l*N-o*G-c*O)*W,t[5]=(e*G-s*N+r*O)*W,t[6]=(g*S-p*_-m*A)*W,t[7]=(h*_-d*S+f*A)*W,t[8]=(o*z-a*N+c*T)*W,t[9]=(n*N-e*z-r*T)*W,t[10]=(p*E-x*S+m*v)*W,t[11]=(u*S-h*E-f*v)*W,t[12]=(a*O-o*D-l*T)*W,t[13]=(e*D-n*O+s*T)*W,t[14]=(x*A-p*C-g*v)*W,t[15]=(h*C-u*A+d*v)*W,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,p=r*u,x=o*h,g=o*u,m=a*u,v=l*c,A=l*h,S=l*u,C=n.x,E=n.y,_=n.z;return s[0]=(1-(x+m))*C,s[1]=(f+S)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-S)*E,s[5]=(1-(d+m))*E,s[6]=(g+v)*E,s[7]=0,s[8]=(p+A)*_,s[9]=(g-v)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=xo.set(s[0],s[1],s[2]).length(),a=xo.set(s[4],s[5],s[6]).length(),l=xo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Vi.copy(this);let c=1/o,h=1/a,u=1/l;return Vi.elements[0]*=c,Vi.elements[1]*=c,Vi.elements[2]*=c,Vi.elements[4]*=h,Vi.elements[5]*=h,Vi.elements[6]*=h,Vi.elements[8]*=u,Vi.elements[9]*=u,Vi.elements[10]*=u,e.setFromRotationMatrix(Vi),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=Ri,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Ri)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===No)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ri,l=!1){let c=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Ri)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===No)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},xo=new B,Vi=new Ue,US=new B(0,0,0),OS=new B(1,1,1),js=new B,Tc=new B,fi=new B,F0=new Ue,U0=new _i,Is=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:$t("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return F0.makeRotationFromQuaternion(t),this.setFromRotationMatrix(F0,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return U0.setFromEuler(this),this.setFromQuaternion(U0,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Is.DEFAULT_ORDER="XYZ";var Ba=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},kS=0,O0=new B,vo=new _i,Ms=new Ue,Ec=new B,Ta=new B,BS=new B,zS=new _i,k0=new B(1,0,0),B0=new B(0,1,0),z0=new B(0,0,1),H0={type:"added"},HS={type:"removed"},bo={type:"childadded",child:null},df={type:"childremoved",child:null},Nn=class i extends Xi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:kS++}),this.uuid=$o(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new B,e=new Is,n=new _i,s=new B(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ue},normalMatrix:{value:new ee}}),this.matrix=new Ue,this.matrixWorld=new Ue,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ba,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return vo.setFromAxisAngle(t,e),this.quaternion.multiply(vo),this}rotateOnWorldAxis(t,e){return vo.setFromAxisAngle(t,e),this.quaternion.premultiply(vo),this}rotateX(t){return this.rotateOnAxis(k0,t)}rotateY(t){return this.rotateOnAxis(B0,t)}rotateZ(t){return this.rotateOnAxis(z0,t)}translateOnAxis(t,e){return O0.copy(t).applyQuaternion(this.quaternion),this.position.add(O0.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(k0,t)}translateY(t){return this.translateOnAxis(B0,t)}translateZ(t){return this.translateOnAxis(z0,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ms.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Ec.copy(t):Ec.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ms.lookAt(Ta,Ec,this.up):Ms.lookAt(Ec,Ta,this.up),this.quaternion.setFromRotationMatrix(Ms),s&&(Ms.extractRotation(s.matrixWorld),vo.setFromRotationMatrix(Ms),this.quaternion.premultiply(vo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(H0),bo.child=t,this.dispatchEvent(bo),bo.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(HS),df.child=t,this.dispatchEvent(df),df.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ms.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ms.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ms),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(H0),bo.child=t,this.dispatchEvent(bo),bo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,t,BS),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,zS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new B(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ke=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},VS={type:"move"},ko=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ke,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ke,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ke,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,n),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(VS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ke;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},q_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Qs={h:0,s:0,l:0},Ac={h:0,s:0,l:0};function ff(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var he=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=mi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=n,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ye.workingColorSpace){if(t=fp(t,1),e=ce(e,0,1),n=ce(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=ff(o,r,t+1/3),this.g=ff(o,r,t),this.b=ff(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=mi){function n(r){r!==void 0&&parseFloat(r)<1&&$t("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:$t("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);$t("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=mi){let n=q_[t.toLowerCase()];return n!==void 0?this.setHex(n,e):$t("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Cs(t.r),this.g=Cs(t.g),this.b=Cs(t.b),this}copyLinearToSRGB(t){return this.r=Lo(t.r),this.g=Lo(t.g),this.b=Lo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=mi){return ye.workingToColorSpace(zn.copy(this),t),Math.round(ce(zn.r*255,0,255))*65536+Math.round(ce(zn.g*255,0,255))*256+Math.round(ce(zn.b*255,0,255))}getHexString(t=mi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(zn.copy(this),e);let n=zn.r,s=zn.g,r=zn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(zn.copy(this),e),t.r=zn.r,t.g=zn.g,t.b=zn.b,t}getStyle(t=mi){ye.workingToColorSpace(zn.copy(this),t);let e=zn.r,n=zn.g,s=zn.b;return t!==mi?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Qs),this.setHSL(Qs.h+t,Qs.s+e,Qs.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Qs),t.getHSL(Ac);let n=Ia(Qs.h,Ac.h,e),s=Ia(Qs.s,Ac.s,e),r=Ia(Qs.l,Ac.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},zn=new he;he.NAMES=q_;var za=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Is,this.environmentIntensity=1,this.environmentRotation=new Is,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Gi=new B,ws=new B,pf=new B,Ts=new B,So=new B,Mo=new B,V0=new B,mf=new B,gf=new B,_f=new B,yf=new $e,xf=new $e,vf=new $e,Rs=class i{constructor(t=new B,e=new B,n=new B){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Gi.subVectors(t,e),s.cross(Gi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Gi.subVectors(s,e),ws.subVectors(n,e),pf.subVectors(t,e);let o=Gi.dot(Gi),a=Gi.dot(ws),l=Gi.dot(pf),c=ws.dot(ws),h=ws.dot(pf),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,p=(o*h-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ts)===null?!1:Ts.x>=0&&Ts.y>=0&&Ts.x+Ts.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ts)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ts.x),l.addScaledVector(o,Ts.y),l.addScaledVector(a,Ts.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return yf.setScalar(0),xf.setScalar(0),vf.setScalar(0),yf.fromBufferAttribute(t,e),xf.fromBufferAttribute(t,n),vf.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(yf,r.x),o.addScaledVector(xf,r.y),o.addScaledVector(vf,r.z),o}static isFrontFacing(t,e,n,s){return Gi.subVectors(n,e),ws.subVectors(t,e),Gi.cross(ws).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Gi.subVectors(this.c,this.b),ws.subVectors(this.a,this.b),Gi.cross(ws).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;So.subVectors(s,n),Mo.subVectors(r,n),mf.subVectors(t,n);let l=So.dot(mf),c=Mo.dot(mf);if(l<=0&&c<=0)return e.copy(n);gf.subVectors(t,s);let h=So.dot(gf),u=Mo.dot(gf);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(So,o);_f.subVectors(t,r);let f=So.dot(_f),p=Mo.dot(_f);if(p>=0&&f<=p)return e.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(n).addScaledVector(Mo,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return V0.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(V0,a);let m=1/(g+x+d);return o=x*m,a=d*m,e.copy(n).addScaledVector(So,o).addScaledVector(Mo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ir=class{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Wi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Wi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Wi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Wi):Wi.fromBufferAttribute(r,o),Wi.applyMatrix4(t.matrixWorld),this.expandByPoint(Wi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Rc.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Rc.copy(n.boundingBox)),Rc.applyMatrix4(t.matrixWorld),this.union(Rc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Wi),Wi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ea),Cc.subVectors(this.max,Ea),wo.subVectors(t.a,Ea),To.subVectors(t.b,Ea),Eo.subVectors(t.c,Ea),tr.subVectors(To,wo),er.subVectors(Eo,To),Cr.subVectors(wo,Eo);let e=[0,-tr.z,tr.y,0,-er.z,er.y,0,-Cr.z,Cr.y,tr.z,0,-tr.x,er.z,0,-er.x,Cr.z,0,-Cr.x,-tr.y,tr.x,0,-er.y,er.x,0,-Cr.y,Cr.x,0];return!bf(e,wo,To,Eo,Cc)||(e=[1,0,0,0,1,0,0,0,1],!bf(e,wo,To,Eo,Cc))?!1:(Pc.crossVectors(tr,er),e=[Pc.x,Pc.y,Pc.z],bf(e,wo,To,Eo,Cc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Wi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Wi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Es),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Es=[new B,new B,new B,new B,new B,new B,new B,new B],Wi=new B,Rc=new ir,wo=new B,To=new B,Eo=new B,tr=new B,er=new B,Cr=new B,Ea=new B,Cc=new B,Pc=new B,Pr=new B;function bf(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Pr.fromArray(i,r);let a=s.x*Math.abs(Pr.x)+s.y*Math.abs(Pr.y)+s.z*Math.abs(Pr.z),l=t.dot(Pr),c=e.dot(Pr),h=n.dot(Pr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new B,Ic=new kt,GS=0,Ci=class extends Xi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:GS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=B_,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=t!==void 0?mp(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ic.fromBufferAttribute(this,e),Ic.applyMatrix3(t),this.setXY(e,Ic.x,Ic.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):W_(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):X_(t,this.array)}};var Ha=class extends Ci{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var Va=class extends Ci{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Oe=class extends Ci{constructor(t,e,n){super(new Float32Array(t),e,n)}},WS=new ir,Aa=new B,Sf=new B,Dr=class{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):WS.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Aa.subVectors(t,this.center);let e=Aa.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Aa,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Sf.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Aa.copy(t.center).add(Sf)),this.expandByPoint(Aa.copy(t.center).sub(Sf))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},XS=0,Ai=new Ue,Mf=new Nn,Ao=new B,pi=new ir,Ra=new ir,Cn=new B,je=class i extends Xi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:XS++}),this.uuid=$o(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(gS(t)?Va:Ha)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new ee().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ai.makeRotationFromQuaternion(t),this.applyMatrix4(Ai),this}rotateX(t){return Ai.makeRotationX(t),this.applyMatrix4(Ai),this}rotateY(t){return Ai.makeRotationY(t),this.applyMatrix4(Ai),this}rotateZ(t){return Ai.makeRotationZ(t),this.applyMatrix4(Ai),this}translate(t,e,n){return Ai.makeTranslation(t,e,n),this.applyMatrix4(Ai),this}scale(t,e,n){return Ai.makeScale(t,e,n),this.applyMatrix4(Ai),this}lookAt(t){return Mf.lookAt(t),Mf.updateMatrix(),this.applyMatrix4(Mf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ao).negate(),this.translate(Ao.x,Ao.y,Ao.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Oe(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&$t("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ir);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];pi.setFromBufferAttribute(r),this.morphTargetsRelative?(Cn.addVectors(this.boundingBox.min,pi.min),this.boundingBox.expandByPoint(Cn),Cn.addVectors(this.boundingBox.max,pi.max),this.boundingBox.expandByPoint(Cn)):(this.boundingBox.expandByPoint(pi.min),this.boundingBox.expandByPoint(pi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Dr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){let n=this.boundingSphere.center;if(pi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ra.setFromBufferAttribute(a),this.morphTargetsRelative?(Cn.addVectors(pi.min,Ra.min),pi.expandByPoint(Cn),Cn.addVectors(pi.max,Ra.max),pi.expandByPoint(Cn)):(pi.expandByPoint(Ra.min),pi.expandByPoint(Ra.max))}pi.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Cn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Cn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Cn.fromBufferAttribute(a,c),l&&(Ao.fromBufferAttribute(t,c),Cn.add(Ao)),s=Math.max(s,n.distanceToSquared(Cn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ci(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new B,l[O]=new B;let h=new B,u=new B,d=new B,f=new kt,p=new kt,x=new kt,g=new B,m=new B;function v(O,N,D){c[O]=c[N]=c[D]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,D),f.fromBufferAttribute(r,O),p.fromBufferAttribute(r,N),x.fromBufferAttribute(r,D),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let z=1/(p.x*x.y-x.x*p.y);isFinite(z)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(z),m.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(z),a[O].add(g),a[N].add(g),a[D].add(g),l[O].add(m),l[N].add(m),l[D].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let O=0,N=A.length;O<N;++O){let D=A[O],z=D.start,G=D.count;for(let L=z,W=z+G;L<W;L+=3)v(t.getX(L+0),t.getX(L+1),t.getX(L+2))}let S=new B,C=new B,E=new B,_=new B;function T(O){E.fromBufferAttribute(s,O),_.copy(E);let N=a[O];S.copy(N),S.sub(E.multiplyScalar(E.dot(N))).normalize(),C.crossVectors(_,N);let z=C.dot(l[O])<0?-1:1;o.setXYZW(O,S.x,S.y,S.z,z)}for(let O=0,N=n.count;O<N;++O)c[O]&&T(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new Ci(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,h=new B,u=new B;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,g),a.add(h),l.add(h),c.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Cn.fromBufferAttribute(t,e),Cn.normalize(),t.setXYZ(e,Cn.x,Cn.y,Cn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*h;for(let m=0;m<h;m++)d[p++]=c[f++]}return new Ci(d,h,u)}if(this.index===null)return $t("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,n);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let l in n){let c=n[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var wf=new B,qS=new B,YS=new ee,gi=class{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=wf.subVectors(n,e).cross(qS.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(wf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||YS.getNormalMatrix(t),s=this.coplanarPoint(wf).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},$S=0,Ls=class extends Xi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:$S++}),this.uuid=$o(),this.name="",this.type="Material",this.blending=Xo,this.side=ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wf,this.blendDst=Xf,this.blendEquation=Or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new he(0,0,0),this.blendAlpha=0,this.depthFunc=Do,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=D_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Kc,this.stencilZFail=Kc,this.stencilZPass=Kc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){$t(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){$t(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new he().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new gi().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new kt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new kt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var As=new B,Tf=new B,Lc=new B,Dc=new B,Nr=class{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,As)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=As.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(As.copy(this.origin).addScaledVector(this.direction,e),As.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Tf.copy(t).add(e).multiplyScalar(.5),Lc.copy(e).sub(t).normalize(),Dc.copy(this.origin).sub(Tf);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Lc),a=Dc.dot(this.direction),l=-Dc.dot(Lc),c=Dc.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*l-a,d=o*a-l,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=p?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Tf).addScaledVector(Lc,d),f}intersectSphere(t,e){if(t.radius<0)return null;As.subVectors(t.center,this.origin);let n=As.dot(this.direction),s=As.dot(As)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(n=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,As)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=n.x-o.x,v=n.y-o.y,A=n.z-o.z,S=Math.abs(l),C=Math.abs(c),E=Math.abs(h),_,T,O,N,D,z,G,L,W,Y,V,ht;if(S>=C&&S>=E?(O=l,z=u,W=p,ht=m,l>=0?(_=c,T=h,N=d,D=f,G=x,L=g,Y=v,V=A):(_=h,T=c,N=f,D=d,G=g,L=x,Y=A,V=v)):C>=E?(O=c,z=d,W=x,ht=v,c>=0?(_=h,T=l,N=f,D=u,G=g,L=p,Y=A,V=m):(_=l,T=h,N=u,D=f,G=p,L=g,Y=m,V=A)):(O=h,z=f,W=g,ht=A,h>=0?(_=l,T=c,N=u,D=d,G=p,L=x,Y=m,V=v):(_=c,T=l,N=d,D=u,G=x,L=p,Y=v,V=m)),O===0)return null;let J=_/O,j=T/O,st=1/O,ft=N-J*z,dt=D-j*z,Q=G-J*W,gt=L-j*W,xt=Y-J*ht,Rt=V-j*ht,Mt=xt*gt-Rt*Q,Xt=ft*Rt-dt*xt,se=Q*dt-gt*ft;if(s){if(Mt<0||Xt<0||se<0)return null}else if((Mt<0||Xt<0||se<0)&&(Mt>0||Xt>0||se>0))return null;let Gt=Mt+Xt+se;if(Gt===0)return null;let de=st*(Mt*z+Xt*W+se*ht);return(Gt>0?de<0:de>0)?null:this.at(de/Gt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ds=class extends Ls{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Oh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},G0=new Ue,Ir=new Nr,Nc=new Dr,W0=new B,Fc=new B,Uc=new B,Oc=new B,Ef=new B,kc=new B,X0=new B,Bc=new B,Xe=class extends Nn{constructor(t=new je,e=new Ds){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){kc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Ef.fromBufferAttribute(u,t),o?kc.addScaledVector(Ef,h):kc.addScaledVector(Ef.sub(e),h))}e.add(kc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Nc.copy(n.boundingSphere),Nc.applyMatrix4(r),Ir.copy(t.ray).recast(t.near),!(Nc.containsPoint(Ir.origin)===!1&&(Ir.intersectSphere(Nc,W0)===null||Ir.origin.distanceToSquared(W0)>(t.far-t.near)**2))&&(G0.copy(r).invert(),Ir.copy(t.ray).applyMatrix4(G0),!(n.boundingBox!==null&&Ir.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ir)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],v=Math.max(g.start,f.start),A=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let E=a.getX(S),_=a.getX(S+1),T=a.getX(S+2);s=zc(this,m,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let v=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=zc(this,o,t,n,c,h,u,v,A,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let g=d[p],m=o[g.materialIndex],v=Math.max(g.start,f.start),A=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let S=v,C=A;S<C;S+=3){let E=S,_=S+1,T=S+2;s=zc(this,m,t,n,c,h,u,E,_,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=p,m=x;g<m;g+=3){let v=g,A=g+1,S=g+2;s=zc(this,o,t,n,c,h,u,v,A,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function ZS(i,t,e,n,s,r,o,a){let l;if(t.side===Kn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ur,a),l===null)return null;Bc.copy(a),Bc.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Bc);return c<e.near||c>e.far?null:{distance:c,point:Bc.clone(),object:i}}function zc(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Fc),i.getVertexPosition(l,Uc),i.getVertexPosition(c,Oc);let h=ZS(i,t,e,n,Fc,Uc,Oc,X0);if(h){let u=new B;Rs.getBarycoord(X0,Fc,Uc,Oc,u),s&&(h.uv=Rs.getInterpolatedAttribute(s,a,l,c,u,new kt)),r&&(h.uv1=Rs.getInterpolatedAttribute(r,a,l,c,u,new kt)),o&&(h.normal=Rs.getInterpolatedAttribute(o,a,l,c,u,new B),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new B,materialIndex:0};Rs.getNormal(Fc,Uc,Oc,d.normal),h.face=d,h.barycoord=u}return h}var uh=class extends ni{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Pn,h=Pn,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Lr=new Dr,JS=new kt(.5,.5),Hc=new B,sr=class{constructor(t=new gi,e=new gi,n=new gi,s=new gi,r=new gi,o=new gi){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ri,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],g=r[10],m=r[11],v=r[12],A=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,m-p,C-v).normalize(),s[1].setComponents(c+o,f+h,m+p,C+v).normalize(),s[2].setComponents(c+a,f+u,m+x,C+A).normalize(),s[3].setComponents(c-a,f-u,m-x,C-A).normalize(),n)s[4].setComponents(l,d,g,S).normalize(),s[5].setComponents(c-l,f-d,m-g,C-S).normalize();else if(s[4].setComponents(c-l,f-d,m-g,C-S).normalize(),e===Ri)s[5].setComponents(c+l,f+d,m+g,C+S).normalize();else if(e===No)s[5].setComponents(l,d,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Lr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Lr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Lr)}intersectsSprite(t){Lr.center.set(0,0,0);let e=JS.distanceTo(t.center);return Lr.radius=.7071067811865476+e,Lr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Lr)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Hc.x=s.normal.x>0?t.max.x:t.min.x,Hc.y=s.normal.y>0?t.max.y:t.min.y,Hc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Hc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},q0=new Ue,dh=class i{constructor(){this.coordinateSystem=Ri,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];q0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new sr),n[s].setFromProjectionMatrix(q0,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new sr),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var Pi=class extends Ls{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new he(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},fh=new B,ph=new B,Y0=new Ue,Ca=new Nr,Vc=new Dr,Af=new B,$0=new B,Ns=class extends Nn{constructor(t=new je,e=new Pi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)fh.fromBufferAttribute(e,s-1),ph.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=fh.distanceTo(ph);t.setAttribute("lineDistance",new Oe(n,1))}else $t("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Vc.copy(n.boundingSphere),Vc.applyMatrix4(s),Vc.radius+=r,t.ray.intersectsSphere(Vc)===!1)return;Y0.copy(s).invert(),Ca.copy(t.ray).applyMatrix4(Y0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=h.getX(x),v=h.getX(x+1),A=Gc(this,t,Ca,l,m,v,x);A&&e.push(A)}if(this.isLineLoop){let x=h.getX(p-1),g=h.getX(f),m=Gc(this,t,Ca,l,x,g,p-1);m&&e.push(m)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,g=p-1;x<g;x+=c){let m=Gc(this,t,Ca,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=Gc(this,t,Ca,l,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Gc(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(fh.fromBufferAttribute(a,s),ph.fromBufferAttribute(a,r),e.distanceSqToSegment(fh,ph,Af,$0)>n)return;Af.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Af);if(!(c<t.near||c>t.far))return{distance:c,point:$0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Z0=new B,J0=new B,ls=class extends Ns{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Z0.fromBufferAttribute(e,s),J0.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Z0.distanceTo(J0);t.setAttribute("lineDistance",new Oe(n,1))}else $t("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ga=class extends Ns{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Wa=class extends ni{constructor(t=[],e=kr,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Fs=class extends ni{constructor(t,e,n=qi,s,r,o,a=Pn,l=Pn,c,h=Ps,u=1){if(h!==Ps&&h!==Os)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Oo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Xa=class extends Fs{constructor(t,e=qi,n=kr,s,r,o=Pn,a=Pn,l,c=Ps){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},qa=class extends ni{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},cs=class i extends je{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Oe(c,3)),this.setAttribute("normal",new Oe(h,3)),this.setAttribute("uv",new Oe(u,2));function p(x,g,m,v,A,S,C,E,_,T,O){let N=S/_,D=C/T,z=S/2,G=C/2,L=E/2,W=_+1,Y=T+1,V=0,ht=0,J=new B;for(let j=0;j<Y;j++){let st=j*D-G;for(let ft=0;ft<W;ft++){let dt=ft*N-z;J[x]=dt*v,J[g]=st*A,J[m]=L,c.push(J.x,J.y,J.z),J[x]=0,J[g]=0,J[m]=E>0?1:-1,h.push(J.x,J.y,J.z),u.push(ft/_),u.push(1-j/T),V+=1}}for(let j=0;j<T;j++)for(let st=0;st<_;st++){let ft=d+st+W*j,dt=d+st+W*(j+1),Q=d+(st+1)+W*(j+1),gt=d+(st+1)+W*j;l.push(ft,dt,gt),l.push(dt,Q,gt),ht+=6}a.addGroup(f,ht,O),f+=ht,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var rr=class i extends je{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],g=n/2,m=0;v(),o===!1&&(t>0&&A(!0),e>0&&A(!1)),this.setIndex(h),this.setAttribute("position",new Oe(u,3)),this.setAttribute("normal",new Oe(d,3)),this.setAttribute("uv",new Oe(f,2));function v(){let S=new B,C=new B,E=0,_=(e-t)/n;for(let T=0;T<=r;T++){let O=[],N=T/r,D=N*(e-t)+t;for(let z=0;z<=s;z++){let G=z/s,L=G*l+a,W=Math.sin(L),Y=Math.cos(L);C.x=D*W,C.y=-N*n+g,C.z=D*Y,u.push(C.x,C.y,C.z),S.set(W,_,Y).normalize(),d.push(S.x,S.y,S.z),f.push(G,1-N),O.push(p++)}x.push(O)}for(let T=0;T<s;T++)for(let O=0;O<r;O++){let N=x[O][T],D=x[O+1][T],z=x[O+1][T+1],G=x[O][T+1];(t>0||O!==0)&&(h.push(N,D,G),E+=3),(e>0||O!==r-1)&&(h.push(D,z,G),E+=3)}c.addGroup(m,E,0),m+=E}function A(S){let C=p,E=new kt,_=new B,T=0,O=S===!0?t:e,N=S===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,g*N,0),d.push(0,N,0),f.push(.5,.5),p++;let D=p;for(let z=0;z<=s;z++){let L=z/s*l+a,W=Math.cos(L),Y=Math.sin(L);_.x=O*Y,_.y=g*N,_.z=O*W,u.push(_.x,_.y,_.z),d.push(0,N,0),E.x=W*.5+.5,E.y=Y*.5*N+.5,f.push(E.x,E.y),p++}for(let z=0;z<s;z++){let G=C+z,L=D+z;S===!0?h.push(L,L+1,G):h.push(L+1,L,G),T+=3}c.addGroup(m,T,S===!0?1:2),m+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Bo=class i extends rr{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Wc=new B,Xc=new B,Rf=new B,qc=new Rs,Fr=class extends je{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Io*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:x,b:g,c:m}=qc;if(x.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),m.fromBufferAttribute(a,c[2]),qc.getNormal(Rf),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let A=(v+1)%3,S=u[v],C=u[A],E=qc[h[v]],_=qc[h[A]],T=`${S}_${C}`,O=`${C}_${S}`,N=d.get(O);N?(Rf.dot(N.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(_.x,_.y,_.z)),d.set(O,null)):d.has(T)||d.set(T,{index0:c[v],index1:c[A],normal:Rf.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:g}=p;Wc.fromBufferAttribute(a,x),Xc.fromBufferAttribute(a,g),f.push(Wc.x,Wc.y,Wc.z),f.push(Xc.x,Xc.y,Xc.z)}this.setAttribute("position",new Oe(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}},Ii=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){$t("Curve: .getPoint() not implemented.")}getPointAt(t,e){let n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){let e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let n=this.getLengths(),s=0,r=n.length,o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);let h=n[s],d=n[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new kt:new B);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){let n=new B,s=[],r=[],o=[],a=new B,l=new Ue;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new B)}r[0]=new B,o[0]=new B;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,n.set(1,0,0)),u<=c&&(c=u,n.set(0,1,0)),d<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(ce(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(l.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(ce(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(l.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Ya=class extends Ii{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new kt){let n=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,f=c-this.aY;l=d*h-f*u+this.aX,c=d*u+f*h+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},mh=class extends Ya{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function _p(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,f=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return i+t*r+e*o+n*a}}}var K0=new B,j0=new B,Cf=new _p,Pf=new _p,If=new _p,zo=class extends Ii{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new B){let n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(j0.subVectors(s[0],s[1]).add(s[0]),c=j0);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(K0.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=K0),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(c.distanceToSquared(u),f),x=Math.pow(u.distanceToSquared(d),f),g=Math.pow(d.distanceToSquared(h),f);x<1e-4&&(x=1),p<1e-4&&(p=x),g<1e-4&&(g=x),Cf.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,p,x,g),Pf.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,p,x,g),If.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,p,x,g)}else this.curveType==="catmullrom"&&(Cf.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Pf.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),If.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return n.set(Cf.calc(l),Pf.calc(l),If.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new B().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Q0(i,t,e,n,s){let r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function KS(i,t){let e=1-i;return e*e*t}function jS(i,t){return 2*(1-i)*i*t}function QS(i,t){return i*i*t}function La(i,t,e,n){return KS(i,t)+jS(i,e)+QS(i,n)}function tM(i,t){let e=1-i;return e*e*e*t}function eM(i,t){let e=1-i;return 3*e*e*i*t}function nM(i,t){return 3*(1-i)*i*i*t}function iM(i,t){return i*i*i*t}function Da(i,t,e,n,s){return tM(i,t)+eM(i,e)+nM(i,n)+iM(i,s)}var gh=class extends Ii{constructor(t=new kt,e=new kt,n=new kt,s=new kt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new kt){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Da(t,s.x,r.x,o.x,a.x),Da(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},_h=class extends Ii{constructor(t=new B,e=new B,n=new B,s=new B){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new B){let n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(Da(t,s.x,r.x,o.x,a.x),Da(t,s.y,r.y,o.y,a.y),Da(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},yh=class extends Ii{constructor(t=new kt,e=new kt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new kt){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new kt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},xh=class extends Ii{constructor(t=new B,e=new B){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new B){let n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new B){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},vh=class extends Ii{constructor(t=new kt,e=new kt,n=new kt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new kt){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(La(t,s.x,r.x,o.x),La(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},$a=class extends Ii{constructor(t=new B,e=new B,n=new B){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new B){let n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(La(t,s.x,r.x,o.x),La(t,s.y,r.y,o.y),La(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},bh=class extends Ii{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new kt){let n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return n.set(Q0(a,l.x,c.x,h.x,u.x),Q0(a,l.y,c.y,h.y,u.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){let s=t.points[e];this.points.push(new kt().fromArray(s))}return this}},sM=Object.freeze({__proto__:null,ArcCurve:mh,CatmullRomCurve3:zo,CubicBezierCurve:gh,CubicBezierCurve3:_h,EllipseCurve:Ya,LineCurve:yh,LineCurve3:xh,QuadraticBezierCurve:vh,QuadraticBezierCurve3:$a,SplineCurve:bh});var Za=class i extends je{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],p=[],x=[],g=[];for(let m=0;m<h;m++){let v=m*d-o;for(let A=0;A<c;A++){let S=A*u-r;p.push(S,-v,0),x.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let A=v+c*m,S=v+c*(m+1),C=v+1+c*(m+1),E=v+1+c*m;f.push(A,S,E),f.push(S,C,E)}this.setIndex(f),this.setAttribute("position",new Oe(p,3)),this.setAttribute("normal",new Oe(x,3)),this.setAttribute("uv",new Oe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var Ja=class i extends je{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new B,d=new B,f=[],p=[],x=[],g=[];for(let m=0;m<=n;m++){let v=[],A=m/n,S=o+A*a,C=t*Math.cos(S),E=Math.sqrt(t*t-C*C),_=0;m===0&&o===0?_=.5/e:m===n&&l===Math.PI&&(_=-.5/e);for(let T=0;T<=e;T++){let O=T/e,N=s+O*r;u.x=-E*Math.cos(N),u.y=C,u.z=E*Math.sin(N),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),g.push(O+_,1-A),v.push(c++)}h.push(v)}for(let m=0;m<n;m++)for(let v=0;v<e;v++){let A=h[m][v+1],S=h[m][v],C=h[m+1][v],E=h[m+1][v+1];(m!==0||o>0)&&f.push(A,S,E),(m!==n-1||l<Math.PI)&&f.push(S,C,E)}this.setIndex(f),this.setAttribute("position",new Oe(p,3)),this.setAttribute("normal",new Oe(x,3)),this.setAttribute("uv",new Oe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ka=class i extends je{constructor(t=new $a(new B(-1,-1,0),new B(-1,1,0),new B(1,1,0)),e=64,n=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:n,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new B,l=new B,c=new kt,h=new B,u=[],d=[],f=[],p=[];x(),this.setIndex(p),this.setAttribute("position",new Oe(u,3)),this.setAttribute("normal",new Oe(d,3)),this.setAttribute("uv",new Oe(f,2));function x(){for(let A=0;A<e;A++)g(A);g(r===!1?e:0),v(),m()}function g(A){h=t.getPointAt(A/e,h);let S=o.normals[A],C=o.binormals[A];for(let E=0;E<=s;E++){let _=E/s*Math.PI*2,T=Math.sin(_),O=-Math.cos(_);l.x=O*S.x+T*C.x,l.y=O*S.y+T*C.y,l.z=O*S.z+T*C.z,l.normalize(),d.push(l.x,l.y,l.z),a.x=h.x+n*l.x,a.y=h.y+n*l.y,a.z=h.z+n*l.z,u.push(a.x,a.y,a.z)}}function m(){for(let A=1;A<=e;A++)for(let S=1;S<=s;S++){let C=(s+1)*(A-1)+(S-1),E=(s+1)*A+(S-1),_=(s+1)*A+S,T=(s+1)*(A-1)+S;p.push(C,E,T),p.push(E,_,T)}}function v(){for(let A=0;A<=e;A++)for(let S=0;S<=s;S++)c.x=A/e,c.y=S/s,f.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new i(new sM[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};function zr(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(t_(s))s.isRenderTargetTexture?($t("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(t_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Hn(i){let t={};for(let e=0;e<i.length;e++){let n=zr(i[e]);for(let s in n)t[s]=n[s]}return t}function t_(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function rM(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function yp(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var Y_={clone:zr,merge:Hn},oM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,aM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,hs=class extends Ls{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=oM,this.fragmentShader=aM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=zr(t.uniforms),this.uniformsGroups=rM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new he().setHex(s.value);break;case"v2":this.uniforms[n].value=new kt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new B().fromArray(s.value);break;case"v4":this.uniforms[n].value=new $e().fromArray(s.value);break;case"m3":this.uniforms[n].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ue().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Sh=class extends hs{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ho=class extends Ls{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new he(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new he(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Mu,this.normalScale=new kt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Is,this.combine=Oh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Mh=class extends Ls{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=I_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},wh=class extends Ls{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ro(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Yc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var or=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Th=class extends or{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Nf,endingEnd:Nf}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ff:r=t,a=2*e-n;break;case Uf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Ff:o=t,l=2*n-e;break;case Uf:o=1,l=n+s[1]-s[0];break;default:o=t-1,l=e}let c=(n-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,g=x*p,m=-d*g+2*d*x-d*p,v=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*p+1,A=(-1-f)*g+(1.5+f)*x+.5*p,S=f*g-f*x;for(let C=0;C!==a;++C)r[C]=m*o[h+C]+v*o[c+C]+A*o[l+C]+S*o[u+C];return r}},Eh=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},Ah=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Rh=class extends or{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=f*d+p*2,v=u[m],A=u[m+1],S=t*d+p*2,C=h[S],E=h[S+1],_=cM(n,e,v,C,s);r[p]=$_(_,x,A,E,g)}return r}};function $_(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function lM(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function cM(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=$_(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let l=lM(r,t,e,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var xi=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ro(e,this.TimeBufferType),this.values=Ro(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Ro(t.times,Array),values:Ro(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Yc(t.settings)&&(n.settings={inTangents:Ro(t.settings.inTangents,Array),outTangents:Ro(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new Ah(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Eh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Th(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Rh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Na:e=this.InterpolantFactoryMethodDiscrete;break;case ah:e=this.InterpolantFactoryMethodLinear;break;case Jc:e=this.InterpolantFactoryMethodSmooth;break;case Df:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $t("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Na;case this.InterpolantFactoryMethodLinear:return ah;case this.InterpolantFactoryMethodSmooth:return Jc;case this.InterpolantFactoryMethodBezier:return Df}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Yc(this.settings)&&(e_(this.settings.inTangents,t),e_(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Yc(this.settings)&&(n_(this.settings.inTangents,t),n_(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){te("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){te("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&_S(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){te("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Jc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Yc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function e_(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function n_(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}xi.prototype.ValueTypeName="";xi.prototype.TimeBufferType=Float32Array;xi.prototype.ValueBufferType=Float32Array;xi.prototype.DefaultInterpolation=ah;var ar=class extends xi{constructor(t,e,n){super(t,e,n)}};ar.prototype.ValueTypeName="bool";ar.prototype.ValueBufferType=Array;ar.prototype.DefaultInterpolation=Na;ar.prototype.InterpolantFactoryMethodLinear=void 0;ar.prototype.InterpolantFactoryMethodSmooth=void 0;var Ch=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Ch.prototype.ValueTypeName="color";var Ph=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Ph.prototype.ValueTypeName="number";var Ih=class extends or{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)_i.slerpFlat(r,0,o,c-a,o,c,l);return r}},ja=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new Ih(this.times,this.values,this.getValueSize(),t)}};ja.prototype.ValueTypeName="quaternion";ja.prototype.InterpolantFactoryMethodSmooth=void 0;var lr=class extends xi{constructor(t,e,n){super(t,e,n)}};lr.prototype.ValueTypeName="string";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Na;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var Lh=class extends xi{constructor(t,e,n,s){super(t,e,n,s)}};Lh.prototype.ValueTypeName="vector";var Dh=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],p=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Z_=new Dh,Nh=class{constructor(t){this.manager=t!==void 0?t:Z_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Nh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Qa=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new he(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},tl=class extends Qa{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new he(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Lf=new Ue,i_=new B,s_=new B,Fh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new kt(512,512),this.mapType=ii,this.map=null,this.mapPass=null,this.matrix=new Ue,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new sr,this._frameExtents=new kt(1,1),this._viewportCount=1,this._viewports=[new $e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;i_.setFromMatrixPosition(t.matrixWorld),e.position.copy(i_),s_.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(s_),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Lf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Lf,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===No||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Lf)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},$c=new B,Zc=new _i,os=new B,el=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ue,this.projectionMatrix=new Ue,this.projectionMatrixInverse=new Ue,this.coordinateSystem=Ri,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose($c,Zc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($c,Zc,os.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose($c,Zc,os),os.x===1&&os.y===1&&os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose($c,Zc,os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},nr=new B,r_=new kt,o_=new kt,Zn=class extends el{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Uo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Io*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Uo*2*Math.atan(Math.tan(Io*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){nr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(nr.x,nr.y).multiplyScalar(-t/nr.z),nr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(nr.x,nr.y).multiplyScalar(-t/nr.z)}getViewSize(t,e){return this.getViewBounds(t,r_,o_),e.subVectors(o_,r_)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Io*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var nl=class extends el{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Of=class extends Fh{constructor(){super(new nl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},il=class extends Qa{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Of}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Co=-90,Po=1,Vo=class extends Nn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zn(Co,Po,t,e);s.layers=this.layers,this.add(s);let r=new Zn(Co,Po,t,e);r.layers=this.layers,this.add(r);let o=new Zn(Co,Po,t,e);o.layers=this.layers,this.add(o);let a=new Zn(Co,Po,t,e);a.layers=this.layers,this.add(a);let l=new Zn(Co,Po,t,e);l.layers=this.layers,this.add(l);let c=new Zn(Co,Po,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ri)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===No)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Uh=class extends Zn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var xp="\\[\\]\\.:\\/",hM=new RegExp("["+xp+"]","g"),vp="[^"+xp+"]",uM="[^"+xp.replace("\\.","")+"]",dM=/((?:WC+[\/:])*)/.source.replace("WC",vp),fM=/(WCOD+)?/.source.replace("WCOD",uM),pM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",vp),mM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",vp),gM=new RegExp("^"+dM+fM+pM+mM+"$"),_M=["material","materials","bones","map"],kf=class{constructor(t,e,n){let s=n||We.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},We=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(hM,"")}static parseTrackName(t){let e=gM.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);_M.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=n(a.children);if(l)return l}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){$t("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=e.objectIndex;switch(n){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(c!==void 0){if(t[c]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;te("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};We.Composite=kf;We.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};We.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};We.prototype.GetterByBindingType=[We.prototype._getValue_direct,We.prototype._getValue_array,We.prototype._getValue_arrayElement,We.prototype._getValue_toArray];We.prototype.SetterByBindingTypeAndVersioning=[[We.prototype._setValue_direct,We.prototype._setValue_direct_setNeedsUpdate,We.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[We.prototype._setValue_array,We.prototype._setValue_array_setNeedsUpdate,We.prototype._setValue_array_setMatrixWorldNeedsUpdate],[We.prototype._setValue_arrayElement,We.prototype._setValue_arrayElement_setNeedsUpdate,We.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[We.prototype._setValue_fromArray,We.prototype._setValue_fromArray_setNeedsUpdate,We.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var aL=new Float32Array(1);var Go=class{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Bf=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var sl=class extends Xi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function bp(i,t,e,n){let s=yM(n);switch(e){case sp:return i*t;case op:return i*t/s.components*s.byteLength;case Wh:return i*t/s.components*s.byteLength;case dr:return i*t*2/s.components*s.byteLength;case Xh:return i*t*2/s.components*s.byteLength;case rp:return i*t*3/s.components*s.byteLength;case Zi:return i*t*4/s.components*s.byteLength;case qh:return i*t*4/s.components*s.byteLength;case al:case ll:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case cl:case hl:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case $h:case Jh:return Math.max(i,16)*Math.max(t,8)/4;case Yh:case Zh:return Math.max(i,8)*Math.max(t,8)/2;case Kh:case jh:case tu:case eu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Qh:case ul:case nu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case iu:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case su:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case ru:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case ou:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case au:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case lu:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case cu:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case hu:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case uu:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case du:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case fu:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case pu:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case mu:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case gu:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case _u:case yu:case xu:return Math.ceil(i/4)*Math.ceil(t/4)*16;case vu:case bu:return Math.ceil(i/4)*Math.ceil(t/4)*8;case dl:case Su:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function yM(i){switch(i){case ii:case tp:return{byteLength:1,components:1};case Yo:case ep:case $i:return{byteLength:2,components:1};case Vh:case Gh:return{byteLength:2,components:4};case qi:case Hh:case Yi:return{byteLength:4,components:1};case np:case ip:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$t("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function _y(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function vM(i){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var bM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,SM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,MM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,wM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,TM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,EM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,AM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,RM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,CM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,PM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,IM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,LM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,DM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,NM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,FM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,UM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,OM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,kM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,BM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,zM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,HM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,VM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,GM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,WM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,XM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,qM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,YM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,$M=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,ZM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,JM="gl_FragColor = linearToOutputTexel( gl_FragColor );",KM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,jM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,QM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,tw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,ew=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,nw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,iw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,sw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,rw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ow=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,aw=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,lw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,cw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,hw=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,uw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,dw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,fw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,pw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,mw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,gw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,_w=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,yw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,xw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,vw=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,bw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Sw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Mw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,ww=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Tw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ew=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Aw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Rw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Cw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Pw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Iw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Lw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Dw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Nw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Fw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Uw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Ow=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,kw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,Bw=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,zw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Hw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Vw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Gw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Ww=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Xw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,qw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Yw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,$w=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Zw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Jw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Kw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,jw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Qw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,tT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,eT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,nT=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,iT=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,sT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,rT=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,oT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,aT=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,lT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,cT=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,hT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,uT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,dT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,fT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,pT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,mT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,gT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,_T=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,yT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,xT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,vT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,bT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ST=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,wT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,TT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ET=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,AT=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,RT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,CT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,PT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,IT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,LT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,DT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,NT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,FT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,UT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,OT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kT=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,BT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,zT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,HT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,VT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,GT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,WT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,XT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,qT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,YT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,$T=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,ZT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,JT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,KT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,QT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ue={alphahash_fragment:bM,alphahash_pars_fragment:SM,alphamap_fragment:MM,alphamap_pars_fragment:wM,alphatest_fragment:TM,alphatest_pars_fragment:EM,aomap_fragment:AM,aomap_pars_fragment:RM,batching_pars_vertex:CM,batching_vertex:PM,begin_vertex:IM,beginnormal_vertex:LM,bsdfs:DM,iridescence_fragment:NM,bumpmap_pars_fragment:FM,clipping_planes_fragment:UM,clipping_planes_pars_fragment:OM,clipping_planes_pars_vertex:kM,clipping_planes_vertex:BM,color_fragment:zM,color_pars_fragment:HM,color_pars_vertex:VM,color_vertex:GM,common:WM,defaultnormal_vertex:XM,displacementmap_pars_vertex:qM,displacementmap_vertex:YM,emissivemap_fragment:$M,emissivemap_pars_fragment:ZM,colorspace_fragment:JM,colorspace_pars_fragment:KM,envmap_fragment:jM,envmap_common_pars_fragment:QM,envmap_pars_fragment:tw,envmap_pars_vertex:ew,envmap_physical_pars_fragment:dw,envmap_vertex:nw,fog_vertex:iw,fog_pars_vertex:sw,fog_fragment:rw,fog_pars_fragment:ow,gradientmap_pars_fragment:aw,lightmap_pars_fragment:lw,lights_lambert_fragment:cw,lights_lambert_pars_fragment:hw,lights_pars_begin:uw,lights_toon_fragment:fw,lights_toon_pars_fragment:pw,lights_phong_fragment:mw,lights_phong_pars_fragment:gw,lights_physical_fragment:_w,lights_physical_pars_fragment:yw,lights_fragment_begin:xw,lights_fragment_maps:vw,lights_fragment_end:bw,lightprobes_pars_fragment:Sw,logdepthbuf_fragment:Mw,logdepthbuf_pars_fragment:ww,logdepthbuf_pars_vertex:Tw,logdepthbuf_vertex:Ew,map_fragment:Aw,map_pars_fragment:Rw,map_particle_fragment:Cw,map_particle_pars_fragment:Pw,metalnessmap_fragment:Iw,metalnessmap_pars_fragment:Lw,morphinstance_vertex:Dw,morphcolor_vertex:Nw,morphnormal_vertex:Fw,morphtarget_pars_vertex:Uw,morphtarget_vertex:Ow,normal_fragment_begin:kw,normal_fragment_maps:Bw,normal_pars_fragment:zw,normal_pars_vertex:Hw,normal_vertex:Vw,normalmap_pars_fragment:Gw,clearcoat_normal_fragment_begin:Ww,clearcoat_normal_fragment_maps:Xw,clearcoat_pars_fragment:qw,iridescence_pars_fragment:Yw,opaque_fragment:$w,packing:Zw,premultiplied_alpha_fragment:Jw,project_vertex:Kw,dithering_fragment:jw,dithering_pars_fragment:Qw,roughnessmap_fragment:tT,roughnessmap_pars_fragment:eT,shadowmap_pars_fragment:nT,shadowmap_pars_vertex:iT,shadowmap_vertex:sT,shadowmask_pars_fragment:rT,skinbase_vertex:oT,skinning_pars_vertex:aT,skinning_vertex:lT,skinnormal_vertex:cT,specularmap_fragment:hT,specularmap_pars_fragment:uT,tonemapping_fragment:dT,tonemapping_pars_fragment:fT,transmission_fragment:pT,transmission_pars_fragment:mT,uv_pars_fragment:gT,uv_pars_vertex:_T,uv_vertex:yT,worldpos_vertex:xT,background_vert:vT,background_frag:bT,backgroundCube_vert:ST,backgroundCube_frag:MT,cube_vert:wT,cube_frag:TT,depth_vert:ET,depth_frag:AT,distance_vert:RT,distance_frag:CT,equirect_vert:PT,equirect_frag:IT,linedashed_vert:LT,linedashed_frag:DT,meshbasic_vert:NT,meshbasic_frag:FT,meshlambert_vert:UT,meshlambert_frag:OT,meshmatcap_vert:kT,meshmatcap_frag:BT,meshnormal_vert:zT,meshnormal_frag:HT,meshphong_vert:VT,meshphong_frag:GT,meshphysical_vert:WT,meshphysical_frag:XT,meshtoon_vert:qT,meshtoon_frag:YT,points_vert:$T,points_frag:ZT,shadow_vert:JT,shadow_frag:KT,sprite_vert:jT,sprite_frag:QT},Dt={common:{diffuse:{value:new he(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new kt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new he(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new he(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new he(16777215)},opacity:{value:1},center:{value:new kt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},ps={basic:{uniforms:Hn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:Hn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Hn([Dt.common,Dt.specularmap,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},specular:{value:new he(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Hn([Dt.common,Dt.envmap,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.roughnessmap,Dt.metalnessmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Hn([Dt.common,Dt.aomap,Dt.lightmap,Dt.emissivemap,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.gradientmap,Dt.fog,Dt.lights,{emissive:{value:new he(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Hn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,Dt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Hn([Dt.points,Dt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Hn([Dt.common,Dt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Hn([Dt.common,Dt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Hn([Dt.common,Dt.bumpmap,Dt.normalmap,Dt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Hn([Dt.sprite,Dt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:Hn([Dt.common,Dt.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:Hn([Dt.lights,Dt.fog,{color:{value:new he(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};ps.physical={uniforms:Hn([ps.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new kt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new he(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new kt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new he(0)},specularColor:{value:new he(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new kt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var wu={r:0,b:0,g:0},t1=new Ue,yy=new ee;yy.set(-1,0,0,0,1,0,0,0,1);function e1(i,t,e,n,s,r){let o=new he(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let A=v.isScene===!0?v.background:null;if(A&&A.isTexture){let S=v.backgroundBlurriness>0;A=t.get(A,S)}return A}function p(v){let A=!1,S=f(v);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,A){let S=f(A);S&&S.isCubeTexture?(c===void 0&&(c=new Xe(new cs(1,1,1),new hs({name:"BackgroundCubeMaterial",uniforms:zr(ps.backgroundCube.uniforms),vertexShader:ps.backgroundCube.vertexShader,fragmentShader:ps.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(t1.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(yy),c.material.toneMapped=ye.getTransfer(S.colorSpace)!==Ee,(h!==S||u!==S.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Xe(new Za(2,2),new hs({name:"BackgroundMaterial",uniforms:zr(ps.background.uniforms),vertexShader:ps.background.vertexShader,fragmentShader:ps.background.fragmentShader,side:ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=ye.getTransfer(S.colorSpace)!==Ee,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,A){v.getRGB(wu,yp(i)),e.buffers.color.setClear(wu.r,wu.g,wu.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,A=1){o.set(v),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:p,addToRenderList:x,dispose:m}}function n1(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,z,G,L,W){let Y=!1,V=u(D,L,G,z);r!==V&&(r=V,c(r.object)),Y=f(D,L,G,W),Y&&p(D,L,G,W),W!==null&&t.update(W,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(D,z,G,L),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,z,G,L){let W=L.wireframe===!0,Y=n[z.id];Y===void 0&&(Y={},n[z.id]=Y);let V=D.isInstancedMesh===!0?D.id:0,ht=Y[V];ht===void 0&&(ht={},Y[V]=ht);let J=ht[G.id];J===void 0&&(J={},ht[G.id]=J);let j=J[W];return j===void 0&&(j=d(l()),J[W]=j),j}function d(D){let z=[],G=[],L=[];for(let W=0;W<e;W++)z[W]=0,G[W]=0,L[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:G,attributeDivisors:L,object:D,attributes:{},index:null}}function f(D,z,G,L){let W=r.attributes,Y=z.attributes,V=0,ht=G.getAttributes();for(let J in ht)if(ht[J].location>=0){let st=W[J],ft=Y[J];if(ft===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(ft=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(ft=D.instanceColor)),st===void 0||st.attribute!==ft||ft&&st.data!==ft.data)return!0;V++}return r.attributesNum!==V||r.index!==L}function p(D,z,G,L){let W={},Y=z.attributes,V=0,ht=G.getAttributes();for(let J in ht)if(ht[J].location>=0){let st=Y[J];st===void 0&&(J==="instanceMatrix"&&D.instanceMatrix&&(st=D.instanceMatrix),J==="instanceColor"&&D.instanceColor&&(st=D.instanceColor));let ft={};ft.attribute=st,st&&st.data&&(ft.data=st.data),W[J]=ft,V++}r.attributes=W,r.attributesNum=V,r.index=L}function x(){let D=r.newAttributes;for(let z=0,G=D.length;z<G;z++)D[z]=0}function g(D){m(D,0)}function m(D,z){let G=r.newAttributes,L=r.enabledAttributes,W=r.attributeDivisors;G[D]=1,L[D]===0&&(i.enableVertexAttribArray(D),L[D]=1),W[D]!==z&&(i.vertexAttribDivisor(D,z),W[D]=z)}function v(){let D=r.newAttributes,z=r.enabledAttributes;for(let G=0,L=z.length;G<L;G++)z[G]!==D[G]&&(i.disableVertexAttribArray(G),z[G]=0)}function A(D,z,G,L,W,Y,V){V===!0?i.vertexAttribIPointer(D,z,G,W,Y):i.vertexAttribPointer(D,z,G,L,W,Y)}function S(D,z,G,L){x();let W=L.attributes,Y=G.getAttributes(),V=z.defaultAttributeValues;for(let ht in Y){let J=Y[ht];if(J.location>=0){let j=W[ht];if(j===void 0&&(ht==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),ht==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let st=j.normalized,ft=j.itemSize,dt=t.get(j);if(dt===void 0)continue;let Q=dt.buffer,gt=dt.type,xt=dt.bytesPerElement,Rt=gt===i.INT||gt===i.UNSIGNED_INT||j.gpuType===Hh;if(j.isInterleavedBufferAttribute){let Mt=j.data,Xt=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=j.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Gt=0;Gt<J.locationSize;Gt++)m(J.location+Gt,Mt.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Gt=0;Gt<J.locationSize;Gt++)g(J.location+Gt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Gt=0;Gt<J.locationSize;Gt++)A(J.location+Gt,ft/J.locationSize,gt,st,Xt*xt,(se+ft/J.locationSize*Gt)*xt,Rt)}else{if(j.isInstancedBufferAttribute){for(let Mt=0;Mt<J.locationSize;Mt++)m(J.location+Mt,j.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Mt=0;Mt<J.locationSize;Mt++)g(J.location+Mt);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Mt=0;Mt<J.locationSize;Mt++)A(J.location+Mt,ft/J.locationSize,gt,st,ft*xt,ft/J.locationSize*Mt*xt,Rt)}}else if(V!==void 0){let st=V[ht];if(st!==void 0)switch(st.length){case 2:i.vertexAttrib2fv(J.location,st);break;case 3:i.vertexAttrib3fv(J.location,st);break;case 4:i.vertexAttrib4fv(J.location,st);break;default:i.vertexAttrib1fv(J.location,st)}}}}v()}function C(){O();for(let D in n){let z=n[D];for(let G in z){let L=z[G];for(let W in L){let Y=L[W];for(let V in Y)h(Y[V].object),delete Y[V];delete L[W]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let z=n[D.id];for(let G in z){let L=z[G];for(let W in L){let Y=L[W];for(let V in Y)h(Y[V].object),delete Y[V];delete L[W]}}delete n[D.id]}function _(D){for(let z in n){let G=n[z];for(let L in G){let W=G[L];if(W[D.id]===void 0)continue;let Y=W[D.id];for(let V in Y)h(Y[V].object),delete Y[V];delete W[D.id]}}}function T(D){for(let z in n){let G=n[z],L=D.isInstancedMesh===!0?D.id:0,W=G[L];if(W!==void 0){for(let Y in W){let V=W[Y];for(let ht in V)h(V[ht].object),delete V[ht];delete W[Y]}delete G[L],Object.keys(G).length===0&&delete n[z]}}}function O(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:g,disableUnusedAttributes:v}}function i1(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function s1(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Zi&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===$i&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==ii&&_!==Yi&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&($t("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&$t("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&$t("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:v,maxVaryings:A,maxFragmentUniforms:S,maxSamples:C,samples:E}}function r1(i){let t=this,e=null,n=0,s=!1,r=!1,o=new gi,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,m=i.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let v=r?0:n,A=v*4,S=m.clippingState||null;l.value=S,S=h(p,d,A,f);for(let C=0;C!==A;++C)S[C]=e[C];m.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=f;A!==x;++A,S+=4)o.copy(u[A]).applyMatrix4(v,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var ml=class extends yi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Wa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new cs(5,5,5),r=new hs({name:"CubemapFromEquirect",uniforms:zr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Kn,blending:Ur});r.uniforms.tEquirect.value=e;let o=new Xe(s,r),a=e.minFilter;return e.minFilter===Us&&(e.minFilter=Jn),new Vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},J_=256,o1=3,a1=20,xy=256,vy=16,l1=3,c1=new B,h1=new he,Eu=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Vo(1,10,null),this._boxMesh=new Xe(new cs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=c1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(h1));let g=new Vo(n,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Q_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=j_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(J_,pp(t))}_fromTexture(t,e){t.mapping===kr||t.mapping===qo?this._setSize(t.image.length===0?J_:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=K_(t,!1,!1),n=Math.log2(t)-o1;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=K_(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===kr||t.mapping===qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Q_()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=j_()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=u1(),this._integrationMaterial=d1());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/vy);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-l1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(xy*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=f1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function K_(i,t,e){return new ml(i,{minFilter:Us,generateMipmaps:t,type:$i,colorSpace:Fa,depthBuffer:e})}function gl(i,t,e){return new hs({name:i,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Kn,blending:Ur,depthTest:!1,depthWrite:!1})}function u1(){return gl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${xy}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function d1(){return gl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:vy}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function f1(){return gl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${a1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function j_(){return gl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Q_(){return gl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function p1(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===kh||f===Bh)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new ml(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===kh||f===Bh,x=f===kr||f===qo;if(p||x){let g=e.get(d),m=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==m)return n===null&&(n=new Eu(i)),g=p?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let v=d.image;return p&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new Eu(i)),g=p?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===kh?d.mapping=kr:f===Bh&&(d.mapping=qo),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function m1(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Pa("WebGLRenderer: "+n+" extension not supported."),s}}}function g1(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let g in x)t.update(x[g],i.ARRAY_BUFFER)}function u(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let v=x!==null?x.array.length:g.array.length/3-1,A=g.count>=65535?Va:Ha,S=new A(Math.ceil(v/3)*6,1),C=S.array;if(x!==null){let _=x.array;m=x.version;for(let T=0,O=0;T<v;T+=3){let N=_[T+0],D=_[T+1],z=_[T+2];C[O++]=N,C[O++]=D,C[O++]=D,C[O++]=z,C[O++]=z,C[O++]=N}}else{m=g.version;for(let _=0,T=0;_<v;_+=3){let O=_+0,N=_+1,D=_+2;C[T++]=O,C[T++]=N,C[T++]=N,C[T++]=D,C[T++]=D,C[T++]=O}}S.version=m;let E=r.get(p);E&&t.remove(E),r.set(p,S)}function d(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function _1(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function c(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function y1(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function x1(i,t,e){let n=new WeakMap,s=new $e;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let O=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),x===!0&&(A=3);let S=a.attributes.position.count*A,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let E=new Float32Array(S*C*4*u),_=new ka(E,S,C,u);_.type=Yi,_.needsUpdate=!0;let T=A*4;for(let N=0;N<u;N++){let D=g[N],z=m[N],G=v[N],L=S*C*4*N;for(let W=0;W<D.count;W++){let Y=W*T;f===!0&&(s.fromBufferAttribute(D,W),E[L+Y+0]=s.x,E[L+Y+1]=s.y,E[L+Y+2]=s.z,E[L+Y+3]=0),p===!0&&(s.fromBufferAttribute(z,W),E[L+Y+4]=s.x,E[L+Y+5]=s.y,E[L+Y+6]=s.z,E[L+Y+7]=0),x===!0&&(s.fromBufferAttribute(G,W),E[L+Y+8]=s.x,E[L+Y+9]=s.y,E[L+Y+10]=s.z,E[L+Y+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new kt(S,C)},n.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",p),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function v1(i,t,e,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var b1={[qf]:"LINEAR_TONE_MAPPING",[Yf]:"REINHARD_TONE_MAPPING",[$f]:"CINEON_TONE_MAPPING",[Zf]:"ACES_FILMIC_TONE_MAPPING",[Kf]:"AGX_TONE_MAPPING",[jf]:"NEUTRAL_TONE_MAPPING",[Jf]:"CUSTOM_TONE_MAPPING"};function S1(i,t,e,n,s,r){let o=new yi(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new je;h.setAttribute("position",new Oe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Oe([0,2,0,0,2,0],2));let u=new Sh({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Xe(h,u),f=new nl(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,v=null,A=[],S=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let _=0;_<A.length;_++){let T=A[_];T.setSize&&T.setSize(C,E)}},this.setEffects=function(C){A=C,S=A.length>0&&A[0].isRenderPass===!0;let E=o.width,_=o.height;A.length>0&&a===null&&(a=new yi(E,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}),l=new yi(E,_,{type:$i,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(O=>O.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Fs(E,_),r===!0&&(c.format=Os,c.type=Br)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let O=0;O<A.length;O++){let N=A[O];N.setSize&&N.setSize(E,_),T&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(C,E){if(g||C.toneMapping===ds&&A.length===0)return!1;if(v=E,E!==null){let _=E.width,T=E.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return S===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=ds,!0},this.hasRenderPass=function(){return S},this.end=function(C,E){C.toneMapping=m,g=!0;let _=o,T=a;for(let O=0;O<A.length;O++){let N=A[O];N.enabled!==!1&&(N.render(C,T,_,E),N.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(p!==C.outputColorSpace||x!==C.toneMapping){p=C.outputColorSpace,x=C.toneMapping,u.defines={},ye.getTransfer(p)===Ee&&(u.defines.SRGB_TRANSFER="");let O=b1[x];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(d,f),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var by=new ni,Sy=new Fs(1,1),My=new Xa(1),wy=new ka,Ty=new hh,Ey=new Wa,ty=[],ey=[],ny=new Float32Array(16),iy=new Float32Array(9),sy=new Float32Array(4);function Jo(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=ty[s];if(r===void 0&&(r=new Float32Array(s),ty[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function bn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Sn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Ru(i,t){let e=ey[t];e===void 0&&(e=new Int32Array(t),ey[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function M1(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function w1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2fv(this.addr,t),Sn(e,t)}}function T1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(bn(e,t))return;i.uniform3fv(this.addr,t),Sn(e,t)}}function E1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4fv(this.addr,t),Sn(e,t)}}function A1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,n))return;sy.set(n),i.uniformMatrix2fv(this.addr,!1,sy),Sn(e,n)}}function R1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,n))return;iy.set(n),i.uniformMatrix3fv(this.addr,!1,iy),Sn(e,n)}}function C1(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(bn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Sn(e,t)}else{if(bn(e,n))return;ny.set(n),i.uniformMatrix4fv(this.addr,!1,ny),Sn(e,n)}}function P1(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function I1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2iv(this.addr,t),Sn(e,t)}}function L1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;i.uniform3iv(this.addr,t),Sn(e,t)}}function D1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4iv(this.addr,t),Sn(e,t)}}function N1(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function F1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(bn(e,t))return;i.uniform2uiv(this.addr,t),Sn(e,t)}}function U1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(bn(e,t))return;i.uniform3uiv(this.addr,t),Sn(e,t)}}function O1(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(bn(e,t))return;i.uniform4uiv(this.addr,t),Sn(e,t)}}function Cu(i){return i.version===0&&(i.compareFunction=cp,i.needsUpdate=!0),i}function k1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Cu(Sy):r=by,e.setTexture2D(t||r,s)}function B1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Ty,s)}function z1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Cu(My):r=Ey,e.setTextureCube(t||r,s)}function H1(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||wy,s)}function V1(i){switch(i){case 5126:return M1;case 35664:return w1;case 35665:return T1;case 35666:return E1;case 35674:return A1;case 35675:return R1;case 35676:return C1;case 5124:case 35670:return P1;case 35667:case 35671:return I1;case 35668:case 35672:return L1;case 35669:case 35673:return D1;case 5125:return N1;case 36294:return F1;case 36295:return U1;case 36296:return O1;case 35678:case 36198:case 36298:case 36306:case 35682:return k1;case 35679:case 36299:case 36307:return B1;case 35680:case 36300:case 36308:case 36293:return z1;case 36289:case 36303:case 36311:case 36292:return H1}}function G1(i,t){i.uniform1fv(this.addr,t)}function W1(i,t){let e=Jo(t,this.size,2);i.uniform2fv(this.addr,e)}function X1(i,t){let e=Jo(t,this.size,3);i.uniform3fv(this.addr,e)}function q1(i,t){let e=Jo(t,this.size,4);i.uniform4fv(this.addr,e)}function Y1(i,t){let e=Jo(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function $1(i,t){let e=Jo(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Z1(i,t){let e=Jo(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function J1(i,t){i.uniform1iv(this.addr,t)}function K1(i,t){i.uniform2iv(this.addr,t)}function j1(i,t){i.uniform3iv(this.addr,t)}function Q1(i,t){i.uniform4iv(this.addr,t)}function tE(i,t){i.uniform1uiv(this.addr,t)}function eE(i,t){i.uniform2uiv(this.addr,t)}function nE(i,t){i.uniform3uiv(this.addr,t)}function iE(i,t){i.uniform4uiv(this.addr,t)}function sE(i,t,e){let n=this.cache,s=t.length,r=Ru(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Cu(Sy):o=by;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function rE(i,t,e){let n=this.cache,s=t.length,r=Ru(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ty,r[o])}function oE(i,t,e){let n=this.cache,s=t.length,r=Ru(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Cu(My):o=Ey;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function aE(i,t,e){let n=this.cache,s=t.length,r=Ru(e,s);bn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||wy,r[o])}function lE(i){switch(i){case 5126:return G1;case 35664:return W1;case 35665:return X1;case 35666:return q1;case 35674:return Y1;case 35675:return $1;case 35676:return Z1;case 5124:case 35670:return J1;case 35667:case 35671:return K1;case 35668:case 35672:return j1;case 35669:case 35673:return Q1;case 5125:return tE;case 36294:return eE;case 36295:return nE;case 36296:return iE;case 35678:case 36198:case 36298:case 36306:case 35682:return sE;case 35679:case 36299:case 36307:return rE;case 35680:case 36300:case 36308:case 36293:return oE;case 36289:case 36303:case 36311:case 36292:return aE}}var wp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=V1(e.type)}},Tp=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=lE(e.type)}},Ep=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},Sp=/(\w+)(\])?(\[|\.)?/g;function ry(i,t){i.seq.push(t),i.map[t.id]=t}function cE(i,t,e){let n=i.name,s=n.length;for(Sp.lastIndex=0;;){let r=Sp.exec(n),o=Sp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ry(e,c===void 0?new wp(a,i,t):new Tp(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new Ep(a),ry(e,u)),e=u}}}var Zo=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);cE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function oy(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var hE=37297,uE=0;function dE(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var ay=new ee;function fE(i){ye._getMatrix(ay,ye.workingColorSpace,i);let t=`mat3( ${ay.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(i)){case Ua:return[t,"LinearTransferOETF"];case Ee:return[t,"sRGBTransferOETF"];default:return $t("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function ly(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+dE(i.getShaderSource(t),a)}else return r}function pE(i,t){let e=fE(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var mE={[qf]:"Linear",[Yf]:"Reinhard",[$f]:"Cineon",[Zf]:"ACESFilmic",[Kf]:"AgX",[jf]:"Neutral",[Jf]:"Custom"};function gE(i,t){let e=mE[t];return e===void 0?($t("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Tu=new B;function _E(){ye.getLuminanceCoefficients(Tu);let i=Tu.x.toFixed(4),t=Tu.y.toFixed(4),e=Tu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function yE(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(pl).join(`
`)}function xE(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function vE(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function pl(i){return i!==""}function cy(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function hy(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var bE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ap(i){return i.replace(bE,SE)}function SE(i,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ap(e)}var ME=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function uy(i){return i.replace(ME,wE)}function wE(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function dy(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var TE={[rl]:"SHADOWMAP_TYPE_PCF",[Wo]:"SHADOWMAP_TYPE_VSM"};function EE(i){return TE[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var AE={[qo]:"ENVMAP_MODE_REFRACTION"};function RE(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":AE[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var CE={[Oh]:"ENVMAP_BLENDING_MULTIPLY",[R_]:"ENVMAP_BLENDING_MIX",[C_]:"ENVMAP_BLENDING_ADD"};function PE(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":CE[i.combine]||"ENVMAP_BLENDING_NONE"}function IE(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=EE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=RE(e),u=PE(e),d=yE(e),f=xE(r),p=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(pl).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(pl).join(`
`),g.length>0&&(g+=`
`)):(x=[dy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(pl).join(`
`),g=[dy(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ds?"#define TONE_MAPPING":"",e.toneMapping!==ds?ue.tonemapping_pars_fragment:"",e.toneMapping!==ds?gE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,pE("linearToOutputTexel",e.outputColorSpace),_E(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(pl).join(`
`)),o=Ap(o),o=cy(o,e),o=hy(o,e),a=Ap(a),a=cy(a,e),a=hy(a,e),o=uy(o),a=uy(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===up?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===up?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=m+x+o,A=m+g+a,S=oy(s,s.VERTEX_SHADER,v),C=oy(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(N){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(C)||"",L=D.trim(),W=z.trim(),Y=G.trim(),V=!0,ht=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,C);else{let J=ly(s,S,"vertex"),j=ly(s,C,"fragment");te("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+L+`
`+J+`
`+j)}else L!==""?$t("WebGLProgram: Program Info Log:",L):(W===""||Y==="")&&(ht=!1);ht&&(N.diagnostics={runnable:V,programLog:L,vertexShader:{log:W,prefix:x},fragmentShader:{log:Y,prefix:g}})}s.deleteShader(S),s.deleteShader(C),_=new Zo(s,p),T=vE(s,p)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(p,hE)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=uE++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=C,this}var LE=0,Rp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Cp(t),e.set(t,n)),n}},Cp=class{constructor(t){this.id=LE++,this.code=t,this.usedTimes=0}};function DE(i){return i===dr||i===ul||i===dl}function NE(i,t,e,n,s,r){let o=new Ba,a=new Rp,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,O,N,D,z){let G=N.fog,L=D.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||W,Y),ht=d[_.type],J=n.precision;_.precision!==null&&(J=n.getMaxPrecision(_.precision),J!==_.precision&&$t("WebGLProgram.getParameters:",_.precision,"not supported, using",J,"instead."));let j=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,st=j!==void 0?j.length:0,ft=0;L.morphAttributes.position!==void 0&&(ft=1),L.morphAttributes.normal!==void 0&&(ft=2),L.morphAttributes.color!==void 0&&(ft=3);let dt,Q,gt,xt;if(ht){let Ct=ps[ht];dt=Ct.vertexShader,Q=Ct.fragmentShader}else{dt=_.vertexShader,Q=_.fragmentShader;let Ct=a.getVertexShaderStage(_),oe=a.getFragmentShaderStage(_);a.update(_,Ct,oe),gt=Ct.id,xt=oe.id}let Rt=i.getRenderTarget(),Mt=i.state.buffers.depth.getReversed(),Xt=D.isInstancedMesh===!0,se=D.isBatchedMesh===!0,Gt=!!_.map,de=!!_.matcap,ae=!!V,ne=ae&&V.isPMREMTexture===!0,qe=!!_.aoMap,Fe=!!_.lightMap,ln=!!_.bumpMap&&_.wireframe===!1,Pe=!!_.normalMap,wn=!!_.displacementMap,xe=!!_.emissiveMap,gn=!!_.metalnessMap,Qe=!!_.roughnessMap,cn=_.anisotropy>0,U=_.clearcoat>0,Pt=_.diffuseRoughness>0,Zt=_.dispersion>0,re=_.retroreflectivity>0,wt=_.iridescence>0,Le=_.sheen>0,Vt=_.transmission>0,Yt=cn&&!!_.anisotropyMap,R=U&&!!_.clearcoatMap,b=U&&!!_.clearcoatNormalMap,X=U&&!!_.clearcoatRoughnessMap,ut=Pt&&!!_.diffuseRoughnessMap,at=wt&&!!_.iridescenceMap,yt=wt&&!!_.iridescenceThicknessMap,vt=Le&&!!_.sheenColorMap,tt=Le&&!!_.sheenRoughnessMap,nt=!!_.specularMap,mt=!!_.specularColorMap,F=!!_.specularIntensityMap,rt=Vt&&!!_.transmissionMap,et=Vt&&!!_.thicknessMap,Tt=!!_.gradientMap,_t=!!_.alphaMap,St=_.alphaTest>0,Wt=!!_.alphaHash,Kt=!!_.extensions,ct=ds;_.toneMapped&&(Rt===null||Rt.isXRRenderTarget===!0)&&(ct=i.toneMapping);let Bt=ne?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,jt={shaderID:ht,shaderType:_.type,shaderName:_.name,vertexShader:dt,fragmentShader:Q,defines:_.defines,customVertexShaderID:gt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:J,batching:se,batchingColor:se&&D._colorsTexture!==null,instancing:Xt,instancingColor:Xt&&D.instanceColor!==null,instancingMorph:Xt&&D.morphTexture!==null,outputColorSpace:Rt===null?i.outputColorSpace:Rt.isXRRenderTarget===!0?Rt.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Gt,matcap:de,envMap:ae,envMapMode:ae&&V.mapping,envMapPMREM:ne,envMapMaxLod:ne?Bt.length-1:null,envMapSize:ne?Bt[0].width:null,aoMap:qe,lightMap:Fe,bumpMap:ln,normalMap:Pe,displacementMap:wn,emissiveMap:xe,normalMapObjectSpace:Pe&&_.normalMapType===L_,normalMapTangentSpace:Pe&&_.normalMapType===Mu,packedNormalMap:Pe&&_.normalMapType===Mu&&DE(_.normalMap.format),metalnessMap:gn,roughnessMap:Qe,anisotropy:cn,anisotropyMap:Yt,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:X,diffuseRoughness:Pt,diffuseRoughnessMap:ut,dispersion:Zt,retroreflection:re,iridescence:wt,iridescenceMap:at,iridescenceThicknessMap:yt,sheen:Le,sheenColorMap:vt,sheenRoughnessMap:tt,specularMap:nt,specularColorMap:mt,specularIntensityMap:F,transmission:Vt,transmissionMap:rt,thicknessMap:et,gradientMap:Tt,opaque:_.transparent===!1&&_.blending===Xo&&_.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:Wt,combine:_.combine,mapUv:Gt&&f(_.map.channel),aoMapUv:qe&&f(_.aoMap.channel),lightMapUv:Fe&&f(_.lightMap.channel),bumpMapUv:ln&&f(_.bumpMap.channel),normalMapUv:Pe&&f(_.normalMap.channel),displacementMapUv:wn&&f(_.displacementMap.channel),emissiveMapUv:xe&&f(_.emissiveMap.channel),metalnessMapUv:gn&&f(_.metalnessMap.channel),roughnessMapUv:Qe&&f(_.roughnessMap.channel),anisotropyMapUv:Yt&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:yt&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:tt&&f(_.sheenRoughnessMap.channel),specularMapUv:nt&&f(_.specularMap.channel),specularColorMapUv:mt&&f(_.specularColorMap.channel),specularIntensityMapUv:F&&f(_.specularIntensityMap.channel),transmissionMapUv:rt&&f(_.transmissionMap.channel),thicknessMapUv:et&&f(_.thicknessMap.channel),alphaMapUv:_t&&f(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Pe||cn),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Gt||_t),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&Pe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:st,morphTextureStride:ft,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:z.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:ct,decodeVideoTexture:Gt&&_.map.isVideoTexture===!0&&ye.getTransfer(_.map.colorSpace)===Ee,decodeVideoTextureEmissive:xe&&_.emissiveMap.isVideoTexture===!0&&ye.getTransfer(_.emissiveMap.colorSpace)===Ee,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===us,flipSided:_.side===Kn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Kt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&_.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function x(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)T.push(O),T.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(g(T,_),m(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function g(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function m(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=d[_.type],O;if(T){let N=ps[T];O=Y_.clone(N.uniforms)}else O=_.uniforms;return O}function A(_,T){let O=h.get(T);return O!==void 0?++O.usedTimes:(O=new IE(i,T,_,s),c.push(O),h.set(T,O)),O}function S(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:v,acquireProgram:A,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:E}}function FE(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function UE(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function fy(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function py(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,g,m){let v=i[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:m},i[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=p,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=g,v.group=m),t++,v}function l(d,f,p,x,g,m,v){v.reversedDepth===!0&&(g=-g);let A=a(d,f,p,x,g,m);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):e.push(A)}function c(d,f,p,x,g,m){let v=a(d,f,p,x,g,m);p.transmission>0?n.unshift(v):p.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||UE),n.length>1&&n.sort(f||fy),s.length>1&&s.sort(f||fy)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function OE(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new py,i.set(n,[o])):s>=r.length?(o=new py,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function kE(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new B,color:new he};break;case"SpotLight":e={position:new B,direction:new B,color:new he,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new he,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new he,groundColor:new he};break;case"RectAreaLight":e={color:new he,position:new B,halfWidth:new B,halfHeight:new B};break}return i[t.id]=e,e}}}function BE(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new kt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var zE=0;function HE(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function VE(i){let t=new kE,e=BE(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new B);let s=new B,r=new Ue,o=new Ue;function a(c){let h=0,u=0,d=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let f=0,p=0,x=0,g=0,m=0,v=0,A=0,S=0,C=0,E=0,_=0,T=0,O=0,N=0;c.sort(HE);for(let z=0,G=c.length;z<G;z++){let L=c[z],W=L.color,Y=L.intensity,V=L.distance,ht=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===dr?ht=L.shadow.map.texture:ht=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)h+=W.r*Y,u+=W.g*Y,d+=W.b*Y;else if(L.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(L.sh.coefficients[J],Y);N++}else if(L.isSunLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,st=e.get(L);st.shadowIntensity=j.intensity,st.shadowBias=j.bias,st.shadowNormalBias=j.normalBias,st.shadowRadius=j.radius,st.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[p]=st,n.sunShadowMap[p]=ht;let ft=j.getViewportCount();for(let dt=0;dt<ft;dt++)n.sunShadowMatrix[x+dt]=j.getMatrix(dt),n.sunShadowCascade[x+dt]=j._cascadeData[dt];x+=ft,p++}n.sun[f]=J,f++}else if(L.isDirectionalLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,st=e.get(L);st.shadowIntensity=j.intensity,st.shadowBias=j.bias,st.shadowNormalBias=j.normalBias,st.shadowRadius=j.radius,st.shadowMapSize=j.mapSize,n.directionalShadow[g]=st,n.directionalShadowMap[g]=ht,n.directionalShadowMatrix[g]=L.shadow.matrix,C++}n.directional[g]=J,g++}else if(L.isSpotLight){let J=t.get(L);J.position.setFromMatrixPosition(L.matrixWorld),J.color.copy(W).multiplyScalar(Y),J.distance=V,J.coneCos=Math.cos(L.angle),J.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),J.decay=L.decay,n.spot[v]=J;let j=L.shadow;if(L.map&&(n.spotLightMap[T]=L.map,T++,j.updateMatrices(L),L.castShadow&&O++),n.spotLightMatrix[v]=j.matrix,L.castShadow){let st=e.get(L);st.shadowIntensity=j.intensity,st.shadowBias=j.bias,st.shadowNormalBias=j.normalBias,st.shadowRadius=j.radius,st.shadowMapSize=j.mapSize,n.spotShadow[v]=st,n.spotShadowMap[v]=ht,_++}v++}else if(L.isRectAreaLight){let J=t.get(L);J.color.copy(W).multiplyScalar(Y),J.halfWidth.set(L.width*.5,0,0),J.halfHeight.set(0,L.height*.5,0),n.rectArea[A]=J,A++}else if(L.isPointLight){let J=t.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),J.distance=L.distance,J.decay=L.decay,L.castShadow){let j=L.shadow,st=e.get(L);st.shadowIntensity=j.intensity,st.shadowBias=j.bias,st.shadowNormalBias=j.normalBias,st.shadowRadius=j.radius,st.shadowMapSize=j.mapSize,st.shadowCameraNear=j.camera.near,st.shadowCameraFar=j.camera.far,n.pointShadow[m]=st,n.pointShadowMap[m]=ht,n.pointShadowMatrix[m]=L.shadow.matrix,E++}n.point[m]=J,m++}else if(L.isHemisphereLight){let J=t.get(L);J.skyColor.copy(L.color).multiplyScalar(Y),J.groundColor.copy(L.groundColor).multiplyScalar(Y),n.hemi[S]=J,S++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Dt.LTC_FLOAT_1,n.rectAreaLTC2=Dt.LTC_FLOAT_2):(n.rectAreaLTC1=Dt.LTC_HALF_1,n.rectAreaLTC2=Dt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==A||D.hemiLength!==S||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==N)&&(n.sun.length=f,n.directional.length=g,n.spot.length=v,n.rectArea.length=A,n.point.length=m,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-O,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=N,D.sunLength=f,D.directionalLength=g,D.pointLength=m,D.spotLength=v,D.rectAreaLength=A,D.hemiLength=S,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=N,n.version=zE++)}function l(c,h){let u=0,d=0,f=0,p=0,x=0,g=0,m=h.matrixWorldInverse;for(let v=0,A=c.length;v<A;v++){let S=c[v];if(S.isSunLight){let C=n.sun[u];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),u++}else if(S.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),d++}else if(S.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let C=n.rectArea[x];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:n}}function my(i){let t=new VE(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function GE(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new my(i),t.set(s,[a])):r>=o.length?(a=new my(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var WE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,XE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,qE=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],YE=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],gy=new Ue,fl=new B,Mp=new B;function $E(i,t,e){let n=new sr,s=new kt,r=new kt,o=new $e,a=new Mh,l=new wh,c={},h=e.maxTextureSize,u={[ur]:Kn,[Kn]:ur,[us]:us},d=new hs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new kt},radius:{value:4}},vertexShader:WE,fragmentShader:XE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new je;p.setAttribute("position",new Ci(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Xe(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=rl;let m=this.type;this.render=function(E,_,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===c_&&($t("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=rl);let O=i.getRenderTarget(),N=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),z=i.state;z.setBlending(Ur),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let G=m!==this.type;G&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(W=>W.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,W=E.length;L<W;L++){let Y=E[L],V=Y.shadow;if(V===void 0){$t("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ht=V.getFrameExtents();s.multiply(ht),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ht.x),s.x=r.x*ht.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ht.y),s.y=r.y*ht.y,V.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Wo){if(Y.isPointLight){$t("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new yi(s.x,s.y,{format:dr,type:$i,minFilter:Jn,magFilter:Jn,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new Fs(s.x,s.y,Yi),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=Ps,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Pn,V.map.depthTexture.magFilter=Pn}else Y.isPointLight?(V.map=new ml(s.x),V.map.depthTexture=new Xa(s.x,qi)):(V.map=new yi(s.x,s.y),V.map.depthTexture=new Fs(s.x,s.y,qi)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=Ps,this.type===rl?(V.map.depthTexture.compareFunction=J?lp:ap,V.map.depthTexture.minFilter=Jn,V.map.depthTexture.magFilter=Jn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Pn,V.map.depthTexture.magFilter=Pn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,T);let st=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let ft=0;ft<j;ft++){let dt=V.getCamera(ft);if(Y.isPointLight){let Q=V.camera,gt=V.matrix,xt=Y.distance||Q.far;xt!==Q.far&&(Q.far=xt,Q.updateProjectionMatrix()),fl.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(fl),Mp.copy(Q.position),Mp.add(qE[ft]),Q.up.copy(YE[ft]),Q.lookAt(Mp),Q.updateMatrixWorld(),gt.makeTranslation(-fl.x,-fl.y,-fl.z),gy.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),V._frustum.setFromProjectionMatrix(gy,Q.coordinateSystem,Q.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,ft),i.clear();else{ft===0&&(i.setRenderTarget(V.map),i.clear());let Q=V.getViewport(ft);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),z.viewport(o)}n=V.getFrustum(ft),S(_,T,dt,Y,st,this.type)}V.isPointLightShadow!==!0&&this.type===Wo&&v(V,T),V.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(O,N,D)};function v(E,_){let T=t.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new yi(s.x,s.y,{format:dr,type:$i}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,T,d,x,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,T,f,x,null)}function A(E,_,T,O){let N=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)N=D;else if(N=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let z=N.uuid,G=_.uuid,L=c[z];L===void 0&&(L={},c[z]=L);let W=L[G];W===void 0&&(W=N.clone(),L[G]=W,_.addEventListener("dispose",C)),N=W}if(N.visible=_.visible,N.wireframe=_.wireframe,O===Wo?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:u[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,T.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let z=i.properties.get(N);z.light=T}return N}function S(E,_,T,O,N,D){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Wo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let L=t.update(E),W=E.material;if(Array.isArray(W)){let Y=L.groups;for(let V=0,ht=Y.length;V<ht;V++){let J=Y[V],j=W[J.materialIndex];if(j&&j.visible){let st=A(E,j,O,D);E.onBeforeShadow(i,E,_,T,L,st,J),i.renderBufferDirect(T,null,L,st,E,J),E.onAfterShadow(i,E,_,T,L,st,J)}}}else if(W.visible){let Y=A(E,W,O,D);E.onBeforeShadow(i,E,_,T,L,Y,null),i.renderBufferDirect(T,null,L,Y,E,null),E.onAfterShadow(i,E,_,T,L,Y,null)}}let G=E.children;for(let L=0,W=G.length;L<W;L++)S(G[L],_,T,O,N,D)}function C(E){E.target.removeEventListener("dispose",C);for(let T in c){let O=c[T],N=E.target.uuid;N in O&&(O[N].dispose(),delete O[N])}}}function ZE(i,t){function e(){let F=!1,rt=new $e,et=null,Tt=new $e(0,0,0,0);return{setMask:function(_t){et!==_t&&!F&&(i.colorMask(_t,_t,_t,_t),et=_t)},setLocked:function(_t){F=_t},setClear:function(_t,St,Wt,Kt,ct){ct===!0&&(_t*=Kt,St*=Kt,Wt*=Kt),rt.set(_t,St,Wt,Kt),Tt.equals(rt)===!1&&(i.clearColor(_t,St,Wt,Kt),Tt.copy(rt))},reset:function(){F=!1,et=null,Tt.set(-1,0,0,0)}}}function n(){let F=!1,rt=!1,et=null,Tt=null,_t=null;return{setReversed:function(St){if(rt!==St){let Wt=t.get("EXT_clip_control");St?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),rt=St;let Kt=_t;_t=null,this.setClear(Kt)}},getReversed:function(){return rt},setTest:function(St){St?Mt(i.DEPTH_TEST):Xt(i.DEPTH_TEST)},setMask:function(St){et!==St&&!F&&(i.depthMask(St),et=St)},setFunc:function(St){if(rt&&(St=G_[St]),Tt!==St){switch(St){case jc:i.depthFunc(i.NEVER);break;case Qc:i.depthFunc(i.ALWAYS);break;case th:i.depthFunc(i.LESS);break;case Do:i.depthFunc(i.LEQUAL);break;case eh:i.depthFunc(i.EQUAL);break;case nh:i.depthFunc(i.GEQUAL);break;case ih:i.depthFunc(i.GREATER);break;case sh:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Tt=St}},setLocked:function(St){F=St},setClear:function(St){_t!==St&&(_t=St,rt&&(St=1-St),i.clearDepth(St))},reset:function(){F=!1,et=null,Tt=null,_t=null,rt=!1}}}function s(){let F=!1,rt=null,et=null,Tt=null,_t=null,St=null,Wt=null,Kt=null,ct=null;return{setTest:function(Bt){F||(Bt?Mt(i.STENCIL_TEST):Xt(i.STENCIL_TEST))},setMask:function(Bt){rt!==Bt&&!F&&(i.stencilMask(Bt),rt=Bt)},setFunc:function(Bt,jt,Ct){(et!==Bt||Tt!==jt||_t!==Ct)&&(i.stencilFunc(Bt,jt,Ct),et=Bt,Tt=jt,_t=Ct)},setOp:function(Bt,jt,Ct){(St!==Bt||Wt!==jt||Kt!==Ct)&&(i.stencilOp(Bt,jt,Ct),St=Bt,Wt=jt,Kt=Ct)},setLocked:function(Bt){F=Bt},setClear:function(Bt){ct!==Bt&&(i.clearStencil(Bt),ct=Bt)},reset:function(){F=!1,rt=null,et=null,Tt=null,_t=null,St=null,Wt=null,Kt=null,ct=null}}}let r=new e,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,g=!1,m=null,v=null,A=null,S=null,C=null,E=null,_=null,T=new he(0,0,0),O=0,N=!1,D=null,z=null,G=null,L=null,W=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ht=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(ht=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=ht>=1):J.indexOf("OpenGL ES")!==-1&&(ht=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=ht>=2);let j=null,st={},ft=i.getParameter(i.SCISSOR_BOX),dt=i.getParameter(i.VIEWPORT),Q=new $e().fromArray(ft),gt=new $e().fromArray(dt);function xt(F,rt,et,Tt){let _t=new Uint8Array(4),St=i.createTexture();i.bindTexture(F,St),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Wt=0;Wt<et;Wt++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(rt,0,i.RGBA,1,1,Tt,0,i.RGBA,i.UNSIGNED_BYTE,_t):i.texImage2D(rt+Wt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,_t);return St}let Rt={};Rt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Rt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Rt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Rt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(i.DEPTH_TEST),o.setFunc(Do),ln(!1),Pe(zf),Mt(i.CULL_FACE),qe(Ur);function Mt(F){h[F]!==!0&&(i.enable(F),h[F]=!0)}function Xt(F){h[F]!==!1&&(i.disable(F),h[F]=!1)}function se(F,rt){return d[F]!==rt?(i.bindFramebuffer(F,rt),d[F]=rt,F===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=rt),F===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=rt),!0):!1}function Gt(F,rt){let et=p,Tt=!1;if(F){et=f.get(rt),et===void 0&&(et=[],f.set(rt,et));let _t=F.textures;if(et.length!==_t.length||et[0]!==i.COLOR_ATTACHMENT0){for(let St=0,Wt=_t.length;St<Wt;St++)et[St]=i.COLOR_ATTACHMENT0+St;et.length=_t.length,Tt=!0}}else et[0]!==i.BACK&&(et[0]=i.BACK,Tt=!0);Tt&&i.drawBuffers(et)}function de(F){return x!==F?(i.useProgram(F),x=F,!0):!1}let ae={[Or]:i.FUNC_ADD,[u_]:i.FUNC_SUBTRACT,[d_]:i.FUNC_REVERSE_SUBTRACT};ae[f_]=i.MIN,ae[p_]=i.MAX;let ne={[m_]:i.ZERO,[g_]:i.ONE,[__]:i.SRC_COLOR,[Wf]:i.SRC_ALPHA,[M_]:i.SRC_ALPHA_SATURATE,[b_]:i.DST_COLOR,[x_]:i.DST_ALPHA,[y_]:i.ONE_MINUS_SRC_COLOR,[Xf]:i.ONE_MINUS_SRC_ALPHA,[S_]:i.ONE_MINUS_DST_COLOR,[v_]:i.ONE_MINUS_DST_ALPHA,[w_]:i.CONSTANT_COLOR,[T_]:i.ONE_MINUS_CONSTANT_COLOR,[E_]:i.CONSTANT_ALPHA,[A_]:i.ONE_MINUS_CONSTANT_ALPHA};function qe(F,rt,et,Tt,_t,St,Wt,Kt,ct,Bt){if(F===Ur){g===!0&&(Xt(i.BLEND),g=!1);return}if(g===!1&&(Mt(i.BLEND),g=!0),F!==h_){if(F!==m||Bt!==N){if((v!==Or||C!==Or)&&(i.blendEquation(i.FUNC_ADD),v=Or,C=Or),Bt)switch(F){case Xo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hf:i.blendFunc(i.ONE,i.ONE);break;case Vf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Gf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:te("WebGLState: Invalid blending: ",F);break}else switch(F){case Xo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Vf:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Gf:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",F);break}A=null,S=null,E=null,_=null,T.set(0,0,0),O=0,m=F,N=Bt}return}_t=_t||rt,St=St||et,Wt=Wt||Tt,(rt!==v||_t!==C)&&(i.blendEquationSeparate(ae[rt],ae[_t]),v=rt,C=_t),(et!==A||Tt!==S||St!==E||Wt!==_)&&(i.blendFuncSeparate(ne[et],ne[Tt],ne[St],ne[Wt]),A=et,S=Tt,E=St,_=Wt),(Kt.equals(T)===!1||ct!==O)&&(i.blendColor(Kt.r,Kt.g,Kt.b,ct),T.copy(Kt),O=ct),m=F,N=!1}function Fe(F,rt){F.side===us?Xt(i.CULL_FACE):Mt(i.CULL_FACE);let et=F.side===Kn;rt&&(et=!et),ln(et),F.blending===Xo&&F.transparent===!1?qe(Ur):qe(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Tt=F.stencilWrite;a.setTest(Tt),Tt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),xe(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Mt(i.SAMPLE_ALPHA_TO_COVERAGE):Xt(i.SAMPLE_ALPHA_TO_COVERAGE)}function ln(F){D!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),D=F)}function Pe(F){F!==a_?(Mt(i.CULL_FACE),F!==z&&(F===zf?i.cullFace(i.BACK):F===l_?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Xt(i.CULL_FACE),z=F}function wn(F){F!==G&&(V&&i.lineWidth(F),G=F)}function xe(F,rt,et){F?(Mt(i.POLYGON_OFFSET_FILL),(L!==rt||W!==et)&&(L=rt,W=et,o.getReversed()&&(rt=-rt,et=-et),i.polygonOffset(rt,et))):Xt(i.POLYGON_OFFSET_FILL)}function gn(F){F?Mt(i.SCISSOR_TEST):Xt(i.SCISSOR_TEST)}function Qe(F){F===void 0&&(F=i.TEXTURE0+Y-1),j!==F&&(i.activeTexture(F),j=F)}function cn(F,rt,et){et===void 0&&(j===null?et=i.TEXTURE0+Y-1:et=j);let Tt=st[et];Tt===void 0&&(Tt={type:void 0,texture:void 0},st[et]=Tt),(Tt.type!==F||Tt.texture!==rt)&&(j!==et&&(i.activeTexture(et),j=et),i.bindTexture(F,rt||Rt[F]),Tt.type=F,Tt.texture=rt)}function U(){let F=st[j];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pt(){try{i.compressedTexImage2D(...arguments)}catch(F){te("WebGLState:",F)}}function Zt(){try{i.compressedTexImage3D(...arguments)}catch(F){te("WebGLState:",F)}}function re(){try{i.texSubImage2D(...arguments)}catch(F){te("WebGLState:",F)}}function wt(){try{i.texSubImage3D(...arguments)}catch(F){te("WebGLState:",F)}}function Le(){try{i.compressedTexSubImage2D(...arguments)}catch(F){te("WebGLState:",F)}}function Vt(){try{i.compressedTexSubImage3D(...arguments)}catch(F){te("WebGLState:",F)}}function Yt(){try{i.texStorage2D(...arguments)}catch(F){te("WebGLState:",F)}}function R(){try{i.texStorage3D(...arguments)}catch(F){te("WebGLState:",F)}}function b(){try{i.texImage2D(...arguments)}catch(F){te("WebGLState:",F)}}function X(){try{i.texImage3D(...arguments)}catch(F){te("WebGLState:",F)}}function ut(F){return u[F]!==void 0?u[F]:i.getParameter(F)}function at(F,rt){u[F]!==rt&&(i.pixelStorei(F,rt),u[F]=rt)}function yt(F){Q.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function vt(F){gt.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),gt.copy(F))}function tt(F,rt){let et=c.get(rt);et===void 0&&(et=new WeakMap,c.set(rt,et));let Tt=et.get(F);Tt===void 0&&(Tt=i.getUniformBlockIndex(rt,F.name),i.uniformBlockBinding(rt,Tt,Tt),et.set(F,Tt))}function nt(F,rt,et){let _t=c.get(rt).get(F);l[_t]!==et&&(i.bindBufferBase(i.UNIFORM_BUFFER,_t,et),l[_t]=et)}function mt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,st={},d={},l={},f=new WeakMap,p=[],x=null,g=!1,m=null,v=null,A=null,S=null,C=null,E=null,_=null,T=new he(0,0,0),O=0,N=!1,D=null,z=null,G=null,L=null,W=null,Q.set(0,0,i.canvas.width,i.canvas.height),gt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Xt,bindFramebuffer:se,drawBuffers:Gt,useProgram:de,setBlending:qe,setMaterial:Fe,setFlipSided:ln,setCullFace:Pe,setLineWidth:wn,setPolygonOffset:xe,setScissorTest:gn,activeTexture:Qe,bindTexture:cn,unbindTexture:U,compressedTexImage2D:Pt,compressedTexImage3D:Zt,texImage2D:b,texImage3D:X,pixelStorei:at,getParameter:ut,updateUBOMapping:tt,uniformBlockBinding:nt,texStorage2D:Yt,texStorage3D:R,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:Le,compressedTexSubImage3D:Vt,scissor:yt,viewport:vt,reset:mt}}function JE(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new kt,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,b){return g?new OffscreenCanvas(R,b):Oa("canvas")}function v(R,b,X){let ut=1,at=Yt(R);if((at.width>X||at.height>X)&&(ut=X/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let yt=Math.floor(ut*at.width),vt=Math.floor(ut*at.height);d===void 0&&(d=m(yt,vt));let tt=b?m(yt,vt):d;return tt.width=yt,tt.height=vt,tt.getContext("2d").drawImage(R,0,0,yt,vt),$t("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+yt+"x"+vt+")."),tt}else return"data"in R&&$t("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(R,b,X,ut,at,yt=!1){if(R!==null){if(i[R]!==void 0)return i[R];$t("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let vt;ut&&(vt=t.get("EXT_texture_norm16"),vt||$t("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let tt=b;if(b===i.RED&&(X===i.FLOAT&&(tt=i.R32F),X===i.HALF_FLOAT&&(tt=i.R16F),X===i.UNSIGNED_BYTE&&(tt=i.R8),X===i.UNSIGNED_SHORT&&vt&&(tt=vt.R16_EXT),X===i.SHORT&&vt&&(tt=vt.R16_SNORM_EXT)),b===i.RED_INTEGER&&(X===i.UNSIGNED_BYTE&&(tt=i.R8UI),X===i.UNSIGNED_SHORT&&(tt=i.R16UI),X===i.UNSIGNED_INT&&(tt=i.R32UI),X===i.BYTE&&(tt=i.R8I),X===i.SHORT&&(tt=i.R16I),X===i.INT&&(tt=i.R32I)),b===i.RG&&(X===i.FLOAT&&(tt=i.RG32F),X===i.HALF_FLOAT&&(tt=i.RG16F),X===i.UNSIGNED_BYTE&&(tt=i.RG8),X===i.UNSIGNED_SHORT&&vt&&(tt=vt.RG16_EXT),X===i.SHORT&&vt&&(tt=vt.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(X===i.UNSIGNED_BYTE&&(tt=i.RG8UI),X===i.UNSIGNED_SHORT&&(tt=i.RG16UI),X===i.UNSIGNED_INT&&(tt=i.RG32UI),X===i.BYTE&&(tt=i.RG8I),X===i.SHORT&&(tt=i.RG16I),X===i.INT&&(tt=i.RG32I)),b===i.RGB_INTEGER&&(X===i.UNSIGNED_BYTE&&(tt=i.RGB8UI),X===i.UNSIGNED_SHORT&&(tt=i.RGB16UI),X===i.UNSIGNED_INT&&(tt=i.RGB32UI),X===i.BYTE&&(tt=i.RGB8I),X===i.SHORT&&(tt=i.RGB16I),X===i.INT&&(tt=i.RGB32I)),b===i.RGBA_INTEGER&&(X===i.UNSIGNED_BYTE&&(tt=i.RGBA8UI),X===i.UNSIGNED_SHORT&&(tt=i.RGBA16UI),X===i.UNSIGNED_INT&&(tt=i.RGBA32UI),X===i.BYTE&&(tt=i.RGBA8I),X===i.SHORT&&(tt=i.RGBA16I),X===i.INT&&(tt=i.RGBA32I)),b===i.RGB&&(X===i.UNSIGNED_SHORT&&vt&&(tt=vt.RGB16_EXT),X===i.SHORT&&vt&&(tt=vt.RGB16_SNORM_EXT),X===i.UNSIGNED_INT_5_9_9_9_REV&&(tt=i.RGB9_E5),X===i.UNSIGNED_INT_10F_11F_11F_REV&&(tt=i.R11F_G11F_B10F)),b===i.RGBA){let nt=yt?Ua:ye.getTransfer(at);X===i.FLOAT&&(tt=i.RGBA32F),X===i.HALF_FLOAT&&(tt=i.RGBA16F),X===i.UNSIGNED_BYTE&&(tt=nt===Ee?i.SRGB8_ALPHA8:i.RGBA8),X===i.UNSIGNED_SHORT&&vt&&(tt=vt.RGBA16_EXT),X===i.SHORT&&vt&&(tt=vt.RGBA16_SNORM_EXT),X===i.UNSIGNED_SHORT_4_4_4_4&&(tt=i.RGBA4),X===i.UNSIGNED_SHORT_5_5_5_1&&(tt=i.RGB5_A1)}return(tt===i.R16F||tt===i.R32F||tt===i.RG16F||tt===i.RG32F||tt===i.RGBA16F||tt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function _(R,b){let X;return R?b===null||b===qi||b===Br?X=i.DEPTH24_STENCIL8:b===Yi?X=i.DEPTH32F_STENCIL8:b===Yo&&(X=i.DEPTH24_STENCIL8,$t("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===qi||b===Br?X=i.DEPTH_COMPONENT24:b===Yi?X=i.DEPTH_COMPONENT32F:b===Yo&&(X=i.DEPTH_COMPONENT16),X}function T(R,b){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Pn&&R.minFilter!==Jn?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}function O(R){let b=new WeakRef(R);n.get(R).__ref=b,p.add(b),x.register(R,b,b)}function N(R){let b=n.get(R).__ref;b!==void 0&&(p.delete(b),x.unregister(b))}function D(R){G(R.target)}function z(R){L(R.target)}function G(R){R.removeEventListener("dispose",D),N(R),Y(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function L(R){R.removeEventListener("dispose",z),N(R),ht(R)}function W(){for(let R of p){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?L(b):G(b))}p.clear(),u.clear()}function Y(R){let b=n.get(R);if(b.__webglInit===void 0)return;let X=R.source,ut=f.get(X);if(ut){let at=ut[b.__cacheKey];at.usedTimes--,at.usedTimes===0&&V(R),Object.keys(ut).length===0&&f.delete(X)}n.remove(R)}function V(R){let b=n.get(R);i.deleteTexture(b.__webglTexture);let X=R.source,ut=f.get(X);delete ut[b.__cacheKey],o.memory.textures--}function ht(R){let b=n.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&G(X),R.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(b.__webglFramebuffer[at]))for(let yt=0;yt<b.__webglFramebuffer[at].length;yt++)i.deleteFramebuffer(b.__webglFramebuffer[at][yt]);else i.deleteFramebuffer(b.__webglFramebuffer[at]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[at])}else{if(Array.isArray(b.__webglFramebuffer))for(let at=0;at<b.__webglFramebuffer.length;at++)i.deleteFramebuffer(b.__webglFramebuffer[at]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let at=0;at<b.__webglColorRenderbuffer.length;at++)b.__webglColorRenderbuffer[at]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[at]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let ut=R.textures;for(let at=0,yt=ut.length;at<yt;at++){let vt=n.get(ut[at]);vt.__webglTexture&&(i.deleteTexture(vt.__webglTexture),o.memory.textures--),n.remove(ut[at])}n.remove(R)}let J=0;function j(){J=0}function st(){return J}function ft(R){J=R}function dt(){let R=J;return R>=s.maxTextures&&$t("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function Q(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}function gt(R,b){let X=n.get(R);if(R.isVideoTexture&&Le(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ut=R.image;if(ut===null)$t("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)$t("WebGLRenderer: Texture marked for update but image is incomplete");else{Fe(X,R,b);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,X.__webglTexture,i.TEXTURE0+b)}function xt(R,b){let X=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Fe(X,R,b);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,X.__webglTexture,i.TEXTURE0+b)}function Rt(R,b){let X=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Fe(X,R,b);return}e.bindTexture(i.TEXTURE_3D,X.__webglTexture,i.TEXTURE0+b)}function Mt(R,b){let X=n.get(R);if(R.version>0&&X.__version!==R.version){ln(X,R,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,X.__webglTexture,i.TEXTURE0+b)}let Xt={[rh]:i.REPEAT,[as]:i.CLAMP_TO_EDGE,[oh]:i.MIRRORED_REPEAT},se={[Pn]:i.NEAREST,[P_]:i.NEAREST_MIPMAP_NEAREST,[ol]:i.NEAREST_MIPMAP_LINEAR,[Jn]:i.LINEAR,[zh]:i.LINEAR_MIPMAP_NEAREST,[Us]:i.LINEAR_MIPMAP_LINEAR},Gt={[N_]:i.NEVER,[cp]:i.ALWAYS,[F_]:i.LESS,[ap]:i.LEQUAL,[U_]:i.EQUAL,[lp]:i.GEQUAL,[O_]:i.GREATER,[k_]:i.NOTEQUAL};function de(R,b){if(b.type===Yi&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Jn||b.magFilter===zh||b.magFilter===ol||b.magFilter===Us||b.minFilter===Jn||b.minFilter===zh||b.minFilter===ol||b.minFilter===Us)&&$t("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Xt[b.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Xt[b.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Xt[b.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,se[b.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,se[b.minFilter]),b.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Gt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Pn||b.minFilter!==ol&&b.minFilter!==Us||b.type===Yi&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function ae(R,b){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",D),O(b));let ut=b.source,at=f.get(ut);at===void 0&&(at={},f.set(ut,at));let yt=Q(b);if(yt!==R.__cacheKey){at[yt]===void 0&&(at[yt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,X=!0),at[yt].usedTimes++;let vt=at[R.__cacheKey];vt!==void 0&&(at[R.__cacheKey].usedTimes--,vt.usedTimes===0&&V(b)),R.__cacheKey=yt,R.__webglTexture=at[yt].texture}return X}function ne(R,b,X){return Math.floor(Math.floor(R/X)/b)}function qe(R,b,X,ut){let yt=R.updateRanges;if(yt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,X,ut,b.data);else{yt.sort((F,rt)=>F.start-rt.start);let vt=0;for(let F=1;F<yt.length;F++){let rt=yt[vt],et=yt[F],Tt=rt.start+rt.count,_t=ne(et.start,b.width,4),St=ne(rt.start,b.width,4);et.start<=Tt+1&&_t===St&&ne(et.start+et.count-1,b.width,4)===_t?rt.count=Math.max(rt.count,et.start+et.count-rt.start):(++vt,yt[vt]=et)}yt.length=vt+1;let tt=e.getParameter(i.UNPACK_ROW_LENGTH),nt=e.getParameter(i.UNPACK_SKIP_PIXELS),mt=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let F=0,rt=yt.length;F<rt;F++){let et=yt[F],Tt=Math.floor(et.start/4),_t=Math.ceil(et.count/4),St=Tt%b.width,Wt=Math.floor(Tt/b.width),Kt=_t,ct=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,St),e.pixelStorei(i.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(i.TEXTURE_2D,0,St,Wt,Kt,ct,X,ut,b.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,tt),e.pixelStorei(i.UNPACK_SKIP_PIXELS,nt),e.pixelStorei(i.UNPACK_SKIP_ROWS,mt)}}function Fe(R,b,X){let ut=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(ut=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(ut=i.TEXTURE_3D);let at=ae(R,b),yt=b.source;e.bindTexture(ut,R.__webglTexture,i.TEXTURE0+X);let vt=n.get(yt);if(yt.version!==vt.__version||at===!0){if(e.activeTexture(i.TEXTURE0+X),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let ct=ye.getPrimaries(ye.workingColorSpace),Bt=b.colorSpace===ks?null:ye.getPrimaries(b.colorSpace),jt=b.colorSpace===ks||ct===Bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let nt=v(b.image,!1,s.maxTextureSize);nt=Vt(b,nt);let mt=r.convert(b.format,b.colorSpace),F=r.convert(b.type),rt=E(b.internalFormat,mt,F,b.normalized,b.colorSpace,b.isVideoTexture);de(ut,b);let et,Tt=b.mipmaps,_t=b.isVideoTexture!==!0,St=vt.__version===void 0||at===!0,Wt=yt.dataReady,Kt=T(b,nt);if(b.isDepthTexture)rt=_(b.format===Os,b.type),St&&(_t?e.texStorage2D(i.TEXTURE_2D,1,rt,nt.width,nt.height):e.texImage2D(i.TEXTURE_2D,0,rt,nt.width,nt.height,0,mt,F,null));else if(b.isDataTexture)if(Tt.length>0){_t&&St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,Tt[0].width,Tt[0].height);for(let ct=0,Bt=Tt.length;ct<Bt;ct++)et=Tt[ct],_t?Wt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,et.width,et.height,mt,F,et.data):e.texImage2D(i.TEXTURE_2D,ct,rt,et.width,et.height,0,mt,F,et.data);b.generateMipmaps=!1}else _t?(St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,nt.width,nt.height),Wt&&qe(b,nt,mt,F)):e.texImage2D(i.TEXTURE_2D,0,rt,nt.width,nt.height,0,mt,F,nt.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){_t&&St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,rt,Tt[0].width,Tt[0].height,nt.depth);for(let ct=0,Bt=Tt.length;ct<Bt;ct++)if(et=Tt[ct],b.format!==Zi)if(mt!==null)if(_t){if(Wt)if(b.layerUpdates.size>0){let jt=bp(et.width,et.height,b.format,b.type);for(let Ct of b.layerUpdates){let oe=et.data.subarray(Ct*jt/et.data.BYTES_PER_ELEMENT,(Ct+1)*jt/et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,Ct,et.width,et.height,1,mt,oe)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,et.width,et.height,nt.depth,mt,et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,rt,et.width,et.height,nt.depth,0,et.data,0,0);else $t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Wt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,et.width,et.height,nt.depth,mt,F,et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,rt,et.width,et.height,nt.depth,0,mt,F,et.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(i.TEXTURE_2D,Kt,rt,Tt[0].width,Tt[0].height);for(let ct=0,Bt=Tt.length;ct<Bt;ct++)et=Tt[ct],b.format!==Zi?mt!==null?_t?Wt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ct,0,0,et.width,et.height,mt,et.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,rt,et.width,et.height,0,et.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Wt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,et.width,et.height,mt,F,et.data):e.texImage2D(i.TEXTURE_2D,ct,rt,et.width,et.height,0,mt,F,et.data)}else if(b.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Kt,rt,nt.width,nt.height,nt.depth),Wt)if(b.layerUpdates.size>0){let ct=bp(nt.width,nt.height,b.format,b.type);for(let Bt of b.layerUpdates){let jt=nt.data.subarray(Bt*ct/nt.data.BYTES_PER_ELEMENT,(Bt+1)*ct/nt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Bt,nt.width,nt.height,1,mt,F,jt)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,nt.width,nt.height,nt.depth,mt,F,nt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,rt,nt.width,nt.height,nt.depth,0,mt,F,nt.data);else if(b.isData3DTexture)_t?(St&&e.texStorage3D(i.TEXTURE_3D,Kt,rt,nt.width,nt.height,nt.depth),Wt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,nt.width,nt.height,nt.depth,mt,F,nt.data)):e.texImage3D(i.TEXTURE_3D,0,rt,nt.width,nt.height,nt.depth,0,mt,F,nt.data);else if(b.isFramebufferTexture){if(St)if(_t)e.texStorage2D(i.TEXTURE_2D,Kt,rt,nt.width,nt.height);else{let ct=nt.width,Bt=nt.height;for(let jt=0;jt<Kt;jt++)e.texImage2D(i.TEXTURE_2D,jt,rt,ct,Bt,0,mt,F,null),ct>>=1,Bt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let ct=i.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),nt.parentNode!==ct){ct.appendChild(nt),u.add(b),ct.onpaint=Bt=>{let jt=Bt.changedElements;for(let Ct of u)jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,nt);else{let jt=i.RGBA,Ct=i.RGBA,oe=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,jt,Ct,oe,nt)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Tt.length>0){if(_t&&St){let ct=Yt(Tt[0]);e.texStorage2D(i.TEXTURE_2D,Kt,rt,ct.width,ct.height)}for(let ct=0,Bt=Tt.length;ct<Bt;ct++)et=Tt[ct],_t?Wt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,mt,F,et):e.texImage2D(i.TEXTURE_2D,ct,rt,mt,F,et);b.generateMipmaps=!1}else if(_t){if(St){let ct=Yt(nt);e.texStorage2D(i.TEXTURE_2D,Kt,rt,ct.width,ct.height)}Wt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,F,nt)}else e.texImage2D(i.TEXTURE_2D,0,rt,mt,F,nt);A(b)&&b.mipmapsAutoUpdate===!0&&S(ut),vt.__version=yt.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function ln(R,b,X){if(b.image.length!==6)return;let ut=ae(R,b),at=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+X);let yt=n.get(at);if(at.version!==yt.__version||ut===!0){e.activeTexture(i.TEXTURE0+X);let vt=ye.getPrimaries(ye.workingColorSpace),tt=b.colorSpace===ks?null:ye.getPrimaries(b.colorSpace),nt=b.colorSpace===ks||vt===tt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt);let mt=b.isCompressedTexture||b.image[0].isCompressedTexture,F=b.image[0]&&b.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!F?rt[Ct]=v(b.image[Ct],!0,s.maxCubemapSize):rt[Ct]=F?b.image[Ct].image:b.image[Ct],rt[Ct]=Vt(b,rt[Ct]);let et=rt[0],Tt=r.convert(b.format,b.colorSpace),_t=r.convert(b.type),St=E(b.internalFormat,Tt,_t,b.normalized,b.colorSpace),Wt=b.isVideoTexture!==!0,Kt=yt.__version===void 0||ut===!0,ct=at.dataReady,Bt=T(b,et);de(i.TEXTURE_CUBE_MAP,b);let jt;if(b.isDepthTexture){if(St=_(b.format===Os,b.type),Kt)if(Wt)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,St,et.width,et.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,et.width,et.height,0,Tt,_t,null)}else if(mt){Wt&&Kt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Bt,St,et.width,et.height);for(let Ct=0;Ct<6;Ct++){jt=rt[Ct].mipmaps;for(let oe=0;oe<jt.length;oe++){let ke=jt[oe];b.format!==Zi?Tt!==null?Wt?ct&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ke.width,ke.height,Tt,ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,St,ke.width,ke.height,0,ke.data):$t("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,ke.width,ke.height,Tt,_t,ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,St,ke.width,ke.height,0,Tt,_t,ke.data)}}}else{if(jt=b.mipmaps,Wt&&Kt){jt.length>0&&Bt++;let Ct=Yt(rt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Bt,St,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(F){Wt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,Tt,_t,rt[Ct].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,rt[Ct].width,rt[Ct].height,0,Tt,_t,rt[Ct].data);for(let oe=0;oe<jt.length;oe++){let Vn=jt[oe].image[Ct].image;Wt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Vn.width,Vn.height,Tt,_t,Vn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,St,Vn.width,Vn.height,0,Tt,_t,Vn.data)}}else{Wt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Tt,_t,rt[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,St,Tt,_t,rt[Ct]);for(let oe=0;oe<jt.length;oe++){let ke=jt[oe];Wt?ct&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Tt,_t,ke.image[Ct]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,St,Tt,_t,ke.image[Ct])}}}A(b)&&b.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),yt.__version=at.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function Pe(R,b,X,ut,at,yt){let vt=r.convert(X.format,X.colorSpace),tt=r.convert(X.type),nt=E(X.internalFormat,vt,tt,X.normalized,X.colorSpace),mt=n.get(b),F=n.get(X);if(F.__renderTarget=b,!mt.__hasExternalTextures){let rt=Math.max(1,b.width>>yt),et=Math.max(1,b.height>>yt);at===i.TEXTURE_3D||at===i.TEXTURE_2D_ARRAY?e.texImage3D(at,yt,nt,rt,et,b.depth,0,vt,tt,null):e.texImage2D(at,yt,nt,rt,et,0,vt,tt,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),wt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ut,at,F.__webglTexture,0,re(b)):(at===i.TEXTURE_2D||at>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ut,at,F.__webglTexture,yt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function wn(R,b,X){if(i.bindRenderbuffer(i.RENDERBUFFER,R),b.depthBuffer){let ut=b.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,yt=_(b.stencilBuffer,at),vt=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;wt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,re(b),yt,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,re(b),yt,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,yt,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,vt,i.RENDERBUFFER,R)}else{let ut=b.textures;for(let at=0;at<ut.length;at++){let yt=ut[at],vt=r.convert(yt.format,yt.colorSpace),tt=r.convert(yt.type),nt=E(yt.internalFormat,vt,tt,yt.normalized,yt.colorSpace);wt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,re(b),nt,b.width,b.height):X?i.renderbufferStorageMultisample(i.RENDERBUFFER,re(b),nt,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,nt,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xe(R,b,X){let ut=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=n.get(b.depthTexture);at.__renderTarget=b;let yt=ut?b.depthTexture.image[0]:b.depthTexture.image;(!at.__webglTexture||yt.width!==b.width||yt.height!==b.height)&&(yt.width=b.width,yt.height=b.height,b.depthTexture.needsUpdate=!0),ut?Mt(b.depthTexture,0):gt(b.depthTexture,0);let vt=at.__webglTexture,tt=re(b),nt=ut?i.TEXTURE_CUBE_MAP_POSITIVE_X+X:i.TEXTURE_2D,mt=b.depthTexture.format===Os?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Ps)wt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,nt,vt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,nt,vt,0);else if(b.depthTexture.format===Os)wt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,mt,nt,vt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,mt,nt,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(R){let b=n.get(R),X=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let ut=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),ut){let at=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),b.__depthDisposeCallback=at}b.__boundDepthTexture=ut}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(X)for(let ut=0;ut<6;ut++)xe(b.__webglFramebuffer[ut],R,ut);else R.texture.mipmaps.length>0?xe(b.__webglFramebuffer[0],R,0):xe(b.__webglFramebuffer,R,0);else if(X){b.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[ut]),b.__webglDepthbuffer[ut]===void 0)b.__webglDepthbuffer[ut]=i.createRenderbuffer(),wn(b.__webglDepthbuffer[ut],R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=b.__webglDepthbuffer[ut];i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),wn(b.__webglDepthbuffer,R,!1);else{let at=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,yt=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,yt),i.framebufferRenderbuffer(i.FRAMEBUFFER,at,i.RENDERBUFFER,yt)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Qe(R,b,X){let ut=n.get(R);b!==void 0&&Pe(ut.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),X!==void 0&&gn(R)}function cn(R){let b=R.texture,X=n.get(R),ut=n.get(b);R.addEventListener("dispose",z),O(R);let at=R.textures,yt=R.isWebGLCubeRenderTarget===!0,vt=at.length>1;if(vt||(ut.__webglTexture===void 0&&(ut.__webglTexture=i.createTexture()),ut.__version=b.version,o.memory.textures++),yt){X.__webglFramebuffer=[];for(let tt=0;tt<6;tt++)if(b.mipmaps.length>0){X.__webglFramebuffer[tt]=[];for(let nt=0;nt<b.mipmaps.length;nt++)X.__webglFramebuffer[tt][nt]=i.createFramebuffer()}else X.__webglFramebuffer[tt]=i.createFramebuffer()}else{if(b.mipmaps.length>0){X.__webglFramebuffer=[];for(let tt=0;tt<b.mipmaps.length;tt++)X.__webglFramebuffer[tt]=i.createFramebuffer()}else X.__webglFramebuffer=i.createFramebuffer();if(vt)for(let tt=0,nt=at.length;tt<nt;tt++){let mt=n.get(at[tt]);mt.__webglTexture===void 0&&(mt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&wt(R)===!1){X.__webglMultisampledFramebuffer=i.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let tt=0;tt<at.length;tt++){let nt=at[tt];X.__webglColorRenderbuffer[tt]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,X.__webglColorRenderbuffer[tt]);let mt=r.convert(nt.format,nt.colorSpace),F=r.convert(nt.type),rt=E(nt.internalFormat,mt,F,nt.normalized,nt.colorSpace,R.isXRRenderTarget===!0),et=re(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,et,rt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+tt,i.RENDERBUFFER,X.__webglColorRenderbuffer[tt])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=i.createRenderbuffer(),wn(X.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(yt){e.bindTexture(i.TEXTURE_CUBE_MAP,ut.__webglTexture),de(i.TEXTURE_CUBE_MAP,b);for(let tt=0;tt<6;tt++)if(b.mipmaps.length>0)for(let nt=0;nt<b.mipmaps.length;nt++)Pe(X.__webglFramebuffer[tt][nt],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+tt,nt);else Pe(X.__webglFramebuffer[tt],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+tt,0);A(b)?S(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let tt=0,nt=at.length;tt<nt;tt++){let mt=at[tt],F=n.get(mt),rt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),de(rt,mt),Pe(X.__webglFramebuffer,R,mt,i.COLOR_ATTACHMENT0+tt,rt,0),A(mt)&&S(rt)}e.unbindTexture()}else{let tt=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(tt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(tt,ut.__webglTexture),de(tt,b),b.mipmaps.length>0)for(let nt=0;nt<b.mipmaps.length;nt++)Pe(X.__webglFramebuffer[nt],R,b,i.COLOR_ATTACHMENT0,tt,nt);else Pe(X.__webglFramebuffer,R,b,i.COLOR_ATTACHMENT0,tt,0);A(b)?S(tt):b.mipmaps.length>0&&i.texParameteri(tt,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&gn(R)}function U(R){let b=R.textures;for(let X=0,ut=b.length;X<ut;X++){let at=b[X];if(A(at)&&at.mipmapsAutoUpdate===!0){let yt=C(R),vt=n.get(at).__webglTexture;e.bindTexture(yt,vt),S(yt),e.unbindTexture()}}}let Pt=[];function Zt(R){if(R.samples>0){if(wt(R)===!1){let b=R.textures,X=R.width,ut=R.height,at=i.COLOR_BUFFER_BIT,yt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,vt=n.get(R),tt=b.length>1;if(tt)for(let mt=0;mt<b.length;mt++)e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let mt=0;mt<b.length;mt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(at|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(at|=i.STENCIL_BUFFER_BIT)),tt){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let F=n.get(b[mt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,X,ut,0,0,X,ut,at,i.NEAREST),l===!0&&(Pt.length=0,Pt.push(i.COLOR_ATTACHMENT0+mt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pt.push(yt),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),tt)for(let mt=0;mt<b.length;mt++){e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let F=n.get(b[mt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,vt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+mt,i.TEXTURE_2D,F,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let b=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function re(R){return Math.min(s.maxSamples,R.samples)}function wt(R){let b=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Le(R){let b=o.render.frame;h.get(R)!==b&&(h.set(R,b),R.update())}function Vt(R,b){let X=R.colorSpace,ut=R.format,at=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Fa&&X!==ks&&(ye.getTransfer(X)===Ee?(ut!==Zi||at!==ii)&&$t("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",X)),b}function Yt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=j,this.getTextureUnits=st,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=xt,this.setTexture3D=Rt,this.setTextureCube=Mt,this.rebindTextures=Qe,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=Pe,this.useMultisampledRTT=wt,this.dispose=W}function KE(i,t){function e(n,s=ks){let r,o=ye.getTransfer(s);if(n===ii)return i.UNSIGNED_BYTE;if(n===Vh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Gh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===np)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ip)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===tp)return i.BYTE;if(n===ep)return i.SHORT;if(n===Yo)return i.UNSIGNED_SHORT;if(n===Hh)return i.INT;if(n===qi)return i.UNSIGNED_INT;if(n===Yi)return i.FLOAT;if(n===$i)return i.HALF_FLOAT;if(n===sp)return i.ALPHA;if(n===rp)return i.RGB;if(n===Zi)return i.RGBA;if(n===Ps)return i.DEPTH_COMPONENT;if(n===Os)return i.DEPTH_STENCIL;if(n===op)return i.RED;if(n===Wh)return i.RED_INTEGER;if(n===dr)return i.RG;if(n===Xh)return i.RG_INTEGER;if(n===qh)return i.RGBA_INTEGER;if(n===al||n===ll||n===cl||n===hl)if(o===Ee)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===al)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===al)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ll)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===cl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===hl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Yh||n===$h||n===Zh||n===Jh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Yh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===$h)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Zh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Jh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Kh||n===jh||n===Qh||n===tu||n===eu||n===ul||n===nu)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Kh||n===jh)return o===Ee?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Qh)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===tu)return r.COMPRESSED_R11_EAC;if(n===eu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===ul)return r.COMPRESSED_RG11_EAC;if(n===nu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===iu||n===su||n===ru||n===ou||n===au||n===lu||n===cu||n===hu||n===uu||n===du||n===fu||n===pu||n===mu||n===gu)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===iu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===su)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ru)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ou)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===au)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===lu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===cu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===hu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===uu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===du)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===fu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===pu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===mu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===gu)return o===Ee?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===_u||n===yu||n===xu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===_u)return o===Ee?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===yu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===xu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===vu||n===bu||n===dl||n===Su)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===vu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===bu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===dl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Su)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Br?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var jE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,QE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Pp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new qa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new hs({vertexShader:jE,fragmentShader:QE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Xe(new Za(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ip=class extends Xi{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",g=new Pp,m={},v=e.getContextAttributes(),A=null,S=null,C=[],E=[],_=new kt,T=null,O=null,N=new Zn;N.viewport=new $e;let D=new Zn;D.viewport=new $e;let z=[N,D],G=new Uh,L=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let gt=C[Q];return gt===void 0&&(gt=new ko,C[Q]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(Q){let gt=C[Q];return gt===void 0&&(gt=new ko,C[Q]=gt),gt.getGripSpace()},this.getHand=function(Q){let gt=C[Q];return gt===void 0&&(gt=new ko,C[Q]=gt),gt.getHandSpace()};function Y(Q){let gt=E.indexOf(Q.inputSource);if(gt===-1)return;let xt=C[gt];xt!==void 0&&(xt.update(Q.inputSource,Q.frame,c||o),xt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function V(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ht);for(let Q=0;Q<C.length;Q++){let gt=E[Q];gt!==null&&(E[Q]=null,C[Q].disconnect(gt))}L=null,W=null,g.reset();for(let Q in m)delete m[Q];if(t.setRenderTarget(A),f=null,d=null,u=null,s=null,S=null,dt.stop(),n.isPresenting=!1,t.setPixelRatio(T),t.setSize(_.width,_.height,!1),O!==null){let Q=O.camera;Q.fov=O.fov,Q.zoom=O.zoom,Q.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&$t("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&$t("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ht),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Rt=null,Mt=null;v.depth&&(Mt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=v.stencil?Os:Ps,Rt=v.stencil?Br:qi);let Xt={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Xt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),S=new yi(d.textureWidth,d.textureHeight,{format:Zi,type:ii,depthTexture:new Fs(d.textureWidth,d.textureHeight,Rt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new yi(f.framebufferWidth,f.framebufferHeight,{format:Zi,type:ii,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ht(Q){for(let gt=0;gt<Q.removed.length;gt++){let xt=Q.removed[gt],Rt=E.indexOf(xt);Rt>=0&&(E[Rt]=null,C[Rt].disconnect(xt))}for(let gt=0;gt<Q.added.length;gt++){let xt=Q.added[gt],Rt=E.indexOf(xt);if(Rt===-1){for(let Xt=0;Xt<C.length;Xt++)if(Xt>=E.length){E.push(xt),Rt=Xt;break}else if(E[Xt]===null){E[Xt]=xt,Rt=Xt;break}if(Rt===-1)break}let Mt=C[Rt];Mt&&Mt.connect(xt)}}function J(Q,gt){gt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(gt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let gt=Q.near,xt=Q.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(xt=g.depthFar)),G.near=D.near=N.near=gt,G.far=D.far=N.far=xt,(L!==G.near||W!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),L=G.near,W=G.far),G.layers.mask=Q.layers.mask|6,N.layers.mask=G.layers.mask&-5,D.layers.mask=G.layers.mask&-3;let Rt=Q.parent,Mt=G.cameras;J(G,Rt);for(let Xt=0;Xt<Mt.length;Xt++)J(Mt[Xt],Rt);G.projectionMatrix.copy(N.projectionMatrix),G.projectionMatrixInverse.copy(N.projectionMatrixInverse),O===null&&Q.isPerspectiveCamera&&(O={camera:Q,fov:Q.fov,zoom:Q.zoom}),j(Q,G,Rt)};function j(Q,gt,xt){xt===null?Q.matrix.copy(gt.matrixWorld):(Q.matrix.copy(xt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(gt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(gt.projectionMatrix),Q.projectionMatrixInverse.copy(gt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Uo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(G)},this.getCameraTexture=function(Q){return m[Q]};let st=null;function ft(Q,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let Rt=!1;xt.length!==G.cameras.length&&(G.cameras.length=0,Rt=!0);for(let Gt=0;Gt<xt.length;Gt++){let de=xt[Gt],ae=null;if(f!==null)ae=f.getViewport(de);else{let qe=u.getViewSubImage(d,de);ae=qe.viewport,Gt===0&&(t.setRenderTargetTextures(S,qe.colorTexture,qe.depthStencilTexture),t.setRenderTarget(S))}let ne=z[Gt];ne===void 0&&(ne=new Zn,ne.layers.enable(Gt),ne.viewport=new $e,z[Gt]=ne),ne.matrix.fromArray(de.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(de.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Gt===0&&(G.matrix.copy(ne.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Rt===!0&&G.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Gt=u.getDepthInformation(xt[0]);Gt&&Gt.isValid&&Gt.texture&&g.init(Gt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Gt=0;Gt<xt.length;Gt++){let de=xt[Gt].camera;if(de){let ae=m[de];ae||(ae=new qa,m[de]=ae);let ne=u.getCameraImage(de);ae.sourceTexture=ne}}}}for(let xt=0;xt<C.length;xt++){let Rt=E[xt],Mt=C[xt];Rt!==null&&Mt!==void 0&&Mt.update(Rt,gt,c||o)}st&&st(Q,gt),gt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:gt}),p=null}let dt=new _y;dt.setAnimationLoop(ft),this.setAnimationLoop=function(Q){st=Q},this.dispose=function(){}}},tA=new Ue,Ay=new ee;Ay.set(-1,0,0,0,1,0,0,0,1);function eA(i,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,yp(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,v,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),d(g,m),m.isMeshPhysicalMaterial&&f(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,v,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Kn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Kn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let v=t.get(m),A=v.envMap,S=v.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(tA.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Ay),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,v,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*v,g.scale.value=A*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function d(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,v){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Kn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let v=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function nA(i,t,e,n){let s={},r={};function o(v,A){let S=A.program;n.uniformBlockBinding(v,S,s[v.id])}function a(v,A){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",g));let C=A.program;n.updateUBOMapping(v,C);let E=t.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let A=i.createBuffer(),S=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,S,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(v){let A=s[v.id],S=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,_=S.length;E<_;E++){let T=S[E];if(Array.isArray(T))for(let O=0,N=T.length;O<N;O++)h(T[O],E,O,C);else h(T,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(v,A,S,C){if(d(v,A,S,C)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let O=0;O<_.length;O++){let N=_[O],D=x(N,!0);u(N,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function u(v,A,S){typeof v=="number"||typeof v=="boolean"?A[S]=v:v.isMatrix3?(A[S]=v.elements[0],A[S+1]=v.elements[1],A[S+2]=v.elements[2],A[S+3]=0,A[S+4]=v.elements[3],A[S+5]=v.elements[4],A[S+6]=v.elements[5],A[S+7]=0,A[S+8]=v.elements[6],A[S+9]=v.elements[7],A[S+10]=v.elements[8],A[S+11]=0):ArrayBuffer.isView(v)?A.set(v.subarray(0,A.length-S),S):v.toArray(A,S)}function d(v,A,S,C){let E=v.value,_=A+"_"+S;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let T=C[_],O=!1;for(let N=0;N<E.length;N++)f(E[N],T,N)===!0&&(O=!0);return O}return f(E,C,_)}function f(v,A,S){if(A[S]===void 0)return typeof v=="number"||typeof v=="boolean"?A[S]=v:ArrayBuffer.isView(v)?A[S]=v.slice():A[S]=v.clone(),!0;{let C=A[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return A[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function p(v){let A=v.uniforms,S=0,C=16;for(let _=0,T=A.length;_<T;_++){let O=Array.isArray(A[_])?A[_]:[A[_]];for(let N=0,D=O.length;N<D;N++){let z=O[N],G=Array.isArray(z.value)?z.value:[z.value],L=Array.isArray(A[_])||Array.isArray(z.value),W=S;for(let V=0,ht=G.length;V<ht;V++){let J=G[V],j=x(J,L),st=S%C,ft=st%j.boundary,dt=st+ft;S+=ft,dt!==0&&C-dt<j.storage&&(S+=C-dt),V===0&&(W=S),S+=j.storage}let Y=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}let E=S%C;return E>0&&(S+=C-E),v.__size=S,v.__cache={},this}function x(v,A){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?$t("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):$t("WebGLRenderer: Unsupported uniform value type.",v),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(v){let A=v.target;A.removeEventListener("dispose",g),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var iA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function sA(){return fs===null&&(fs=new uh(iA,16,16,dr,$i),fs.name="DFG_LUT",fs.minFilter=Jn,fs.magFilter=Jn,fs.wrapS=as,fs.wrapT=as,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var Au=class{constructor(t={}){let{canvas:e=z_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ii}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,g=new Set([qh,Xh,Wh]),m=new Set([ii,qi,Yo,Br,Vh,Gh]),v=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],T=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ds,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,D=!1,z=null,G=null,L=null,W=null;this._outputColorSpace=mi;let Y=0,V=0,ht=null,J=-1,j=null,st=new $e,ft=new $e,dt=null,Q=new he(0),gt=0,xt=e.width,Rt=e.height,Mt=1,Xt=null,se=null,Gt=new $e(0,0,xt,Rt),de=new $e(0,0,xt,Rt),ae=!1,ne=new sr,qe=new dh,Fe=!1,ln=!1,Pe=new Ue,wn=new B,xe=new $e,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Qe=!1;function cn(){return ht===null?Mt:1}let U=n;function Pt(w,k){return e.getContext(w,k)}let Zt,re,wt,Le,Vt,Yt,R,b,X,ut,at,yt,vt,tt,nt,mt,F,rt,et,Tt,_t,St,Wt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),U===null){let k="webgl2";if(U=Pt(k,w),U===null)throw Pt(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(w){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),te("WebGLRenderer: "+w.message),w}function Kt(){Zt=new m1(U),Zt.init(),_t=new KE(U,Zt),re=new s1(U,Zt,t,_t),wt=new ZE(U,Zt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),G=U.createFramebuffer(),L=U.createFramebuffer(),W=U.createFramebuffer(),Le=new y1(U),Vt=new FE,Yt=new JE(U,Zt,wt,Vt,re,_t,Le),R=new p1(N),b=new vM(U),St=new n1(U,b),X=new g1(U,b,Le,St),ut=new v1(U,X,b,St,Le),rt=new x1(U,re,Yt),nt=new r1(Vt),at=new NE(N,R,Zt,re,St,nt),yt=new eA(N,Vt),vt=new OE,tt=new GE(Zt),F=new e1(N,R,wt,ut,p,l),mt=new $E(N,ut,re),Wt=new nA(U,Le,re,wt),et=new i1(U,Zt,Le),Tt=new _1(U,Zt,Le),Le.programs=at.programs,N.capabilities=re,N.extensions=Zt,N.properties=Vt,N.renderLists=vt,N.shadowMap=mt,N.state=wt,N.info=Le}x!==ii&&(O=new S1(x,e.width,e.height,a,s,r));let ct=new Ip(N,U);this.xr=ct,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=Zt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Zt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(w){w!==void 0&&(Mt=w,this.setSize(xt,Rt,!1))},this.getSize=function(w){return w.set(xt,Rt)},this.setSize=function(w,k,K=!0){if(ct.isPresenting){$t("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=w,Rt=k,e.width=Math.floor(w*Mt),e.height=Math.floor(k*Mt),K===!0&&(e.style.width=w+"px",e.style.height=k+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,w,k)},this.getDrawingBufferSize=function(w){return w.set(xt*Mt,Rt*Mt).floor()},this.setDrawingBufferSize=function(w,k,K){xt=w,Rt=k,Mt=K,e.width=Math.floor(w*K),e.height=Math.floor(k*K),this.setViewport(0,0,w,k)},this.setEffects=function(w){if(x===ii){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let k=0;k<w.length;k++)if(w[k].isOutputPass===!0){$t("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(st)},this.getViewport=function(w){return w.copy(Gt)},this.setViewport=function(w,k,K,q){w.isVector4?Gt.set(w.x,w.y,w.z,w.w):Gt.set(w,k,K,q),wt.viewport(st.copy(Gt).multiplyScalar(cn()).round())},this.getScissor=function(w){return w.copy(de)},this.setScissor=function(w,k,K,q){w.isVector4?de.set(w.x,w.y,w.z,w.w):de.set(w,k,K,q),wt.scissor(ft.copy(de).multiplyScalar(cn()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(w){wt.setScissorTest(ae=w)},this.setOpaqueSort=function(w){Xt=w},this.setTransparentSort=function(w){se=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,k=!0,K=!0){let q=0;if(w){let $=!1;if(ht!==null){let Et=ht.texture.format;$=g.has(Et)}if($){let Et=ht.texture.type,It=m.has(Et),At=F.getClearColor(),Lt=F.getClearAlpha(),Ht=At.r,Qt=At.g,fe=At.b;It?(v[0]=Ht,v[1]=Qt,v[2]=fe,v[3]=Lt,U.clearBufferuiv(U.COLOR,0,v)):(A[0]=Ht,A[1]=Qt,A[2]=fe,A[3]=Lt,U.clearBufferiv(U.COLOR,0,A))}else q|=U.COLOR_BUFFER_BIT}k&&(q|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(q|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),q!==0&&U.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),z=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),F.dispose(),vt.dispose(),tt.dispose(),Yt.dispose(),Vt.dispose(),R.dispose(),ut.dispose(),X.dispose(),St.dispose(),Wt.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",vl),ct.removeEventListener("sessionend",Ji),ms.stop()};function Bt(w){w.preventDefault(),dp("WebGLRenderer: Context Lost."),D=!0}function jt(){dp("WebGLRenderer: Context Restored."),D=!1;let w=Le.autoReset,k=mt.enabled,K=mt.autoUpdate,q=mt.needsUpdate,$=mt.type;Kt(),Le.autoReset=w,mt.enabled=k,mt.autoUpdate=K,mt.needsUpdate=q,mt.type=$}function Ct(w){te("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function oe(w){let k=w.target;k.removeEventListener("dispose",oe),ke(k)}function ke(w){Vn(w),Vt.remove(w)}function Vn(w){let k=Vt.get(w).programs;k!==void 0&&(k.forEach(function(K){at.releaseProgram(K)}),w.isShaderMaterial&&at.releaseShaderCache(w))}this.renderBufferDirect=function(w,k,K,q,$,Et){k===null&&(k=gn);let It=$.isMesh&&$.matrixWorld.determinantAffine()<0,At=ea(w,k,K,q,$);wt.setMaterial(q,It);let Lt=K.index,Ht=1;if(q.wireframe===!0){if(Lt=X.getWireframeAttribute(K),Lt===void 0)return;Ht=2}let Qt=K.drawRange,fe=K.attributes.position,zt=Qt.start*Ht,pe=(Qt.start+Qt.count)*Ht;Et!==null&&(zt=Math.max(zt,Et.start*Ht),pe=Math.min(pe,(Et.start+Et.count)*Ht)),Lt!==null?(zt=Math.max(zt,0),pe=Math.min(pe,Lt.count)):fe!=null&&(zt=Math.max(zt,0),pe=Math.min(pe,fe.count));let Ze=pe-zt;if(Ze<0||Ze===1/0)return;St.setup($,q,At,K,Lt);let Ae,Re=et;if(Lt!==null&&(Ae=b.get(Lt),Re=Tt,Re.setIndex(Ae)),$.isMesh)q.wireframe===!0?(wt.setLineWidth(q.wireframeLinewidth*cn()),Re.setMode(U.LINES)):Re.setMode(U.TRIANGLES);else if($.isLine){let _n=q.linewidth;_n===void 0&&(_n=1),wt.setLineWidth(_n*cn()),$.isLineSegments?Re.setMode(U.LINES):$.isLineLoop?Re.setMode(U.LINE_LOOP):Re.setMode(U.LINE_STRIP)}else $.isPoints?Re.setMode(U.POINTS):$.isSprite&&Re.setMode(U.TRIANGLES);if($.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Re.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let _n=$._multiDrawStarts,Ut=$._multiDrawCounts,hn=$._multiDrawCount,ge=Lt?b.get(Lt).bytesPerElement:1,_s=Vt.get(q).currentProgram.getUniforms();for(let un=0;un<hn;un++)_s.setValue(U,"_gl_DrawID",un),Re.render(_n[un]/ge,Ut[un])}else if($.isInstancedMesh)Re.renderInstances(zt,Ze,$.count);else if(K.isInstancedBufferGeometry){let _n=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ut=Math.min(K.instanceCount,_n);Re.renderInstances(zt,Ze,Ut)}else Re.render(zt,Ze)};function jo(w,k,K,q){z!==null&&w.isNodeMaterial&&z.setObject(q,w),Fe===!0&&nt.setState(w,K,!1),w.transparent===!0&&w.side===us&&w.forceSinglePass===!1?(w.side=Kn,w.needsUpdate=!0,Ki(w,k,q),w.side=ur,w.needsUpdate=!0,Ki(w,k,q),w.side=us):Ki(w,k,q)}this.compile=function(w,k,K=null){K===null&&(K=w),z!==null&&z.renderStart(w,k,K),E=tt.get(K),E.init(k),T.push(E),K.traverseVisible(function($){$.isLight&&$.layers.test(k.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),w!==K&&w.traverseVisible(function($){$.isLight&&$.layers.test(k.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),ln=this.localClippingEnabled,Fe=nt.init(this.clippingPlanes,ln),Fe===!0&&nt.setGlobalState(this.clippingPlanes,k),z!==null&&mt.render(E.state.shadowsArray,K,k);let q=new Set;return w.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Et=$.material;if(Et)if(Array.isArray(Et))for(let It=0;It<Et.length;It++){let At=Et[It];jo(At,K,k,$),q.add(At)}else jo(Et,K,k,$),q.add(Et)}),E=T.pop(),z!==null&&z.renderEnd(),q},this.compileAsync=function(w,k,K=null){let q=this.compile(w,k,K);return new Promise($=>{function Et(){if(q.forEach(function(It){let Lt=Vt.get(It).currentProgram;(Lt===void 0||Lt.isReady())&&q.delete(It)}),q.size===0){$(w);return}setTimeout(Et,10)}Zt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Vr=null;function td(w){Vr&&Vr(w)}function vl(){ms.stop()}function Ji(){ms.start()}let ms=new _y;ms.setAnimationLoop(td),typeof self<"u"&&ms.setContext(self),this.setAnimationLoop=function(w){Vr=w,ct.setAnimationLoop(w),w===null?ms.stop():ms.start()},ct.addEventListener("sessionstart",vl),ct.addEventListener("sessionend",Ji),this.render=function(w,k){if(k!==void 0&&k.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(w,k);let K=ct.enabled===!0&&ct.isPresenting===!0,q=O!==null&&(ht===null||K)&&O.begin(N,ht);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(k),k=ct.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,k,ht),E=tt.get(w,T.length),E.init(k),E.state.textureUnits=Yt.getTextureUnits(),T.push(E),Pe.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?qe.setFromArrayCamera(k):ne.setFromProjectionMatrix(Pe,Ri,k.reversedDepth),ln=this.localClippingEnabled,Fe=nt.init(this.clippingPlanes,ln),C=vt.get(w,_.length),C.init(),_.push(C),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let It=N.xr.getDepthSensingMesh();It!==null&&gs(It,k,-1/0,N.sortObjects)}gs(w,k,0,N.sortObjects),C.finish(),z!==null&&z.updateLights(E.state.lightsArray),N.sortObjects===!0&&C.sort(Xt,se),Qe=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Qe&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Fe===!0&&nt.beginShadows();let $=E.state.shadowsArray;if(mt.render($,w,k),Fe===!0&&nt.endShadows(),(q&&O.hasRenderPass())===!1){let It=C.opaque,At=C.transmissive;if(E.setupLights(),k.isArrayCamera){let Lt=k.cameras;if(At.length>0)for(let Ht=0,Qt=Lt.length;Ht<Qt;Ht++){let fe=Lt[Ht];Li(It,At,w,fe)}Qe&&F.render(w);for(let Ht=0,Qt=Lt.length;Ht<Qt;Ht++){let fe=Lt[Ht];Qo(C,w,fe,fe.viewport)}}else At.length>0&&Li(It,At,w,k),Qe&&F.render(w),Qo(C,w,k)}ht!==null&&V===0&&(Yt.updateMultisampleRenderTarget(ht),Yt.updateRenderTargetMipmap(ht)),q&&O.end(N),w.isScene===!0&&w.onAfterRender(N,w,k),St.resetDefaultState(),J=-1,j=null,T.pop(),T.length>0?(E=T[T.length-1],Yt.setTextureUnits(E.state.textureUnits),Fe===!0&&nt.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,z!==null&&z.renderEnd()};function gs(w,k,K,q){if(w.visible===!1)return;if(w.layers.test(k.layers)){if(w.isGroup)K=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(k);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let It=k.isArrayCamera?qe:ne;if(!w.frustumCulled||w.intersectsFrustum(It)){q&&xe.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Pe);let At=ut.update(w),Lt=w.material;Lt.visible&&C.push(w,At,Lt,K,xe.z,null,k)}}else if(w.isMesh||w.isLine||w.isPoints){let It=k.isArrayCamera?qe:ne;if(!w.frustumCulled||w.intersectsFrustum(It)){let At=ut.update(w),Lt=w.material;if(q&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xe.copy(w.boundingSphere.center)):(At.boundingSphere===null&&At.computeBoundingSphere(),xe.copy(At.boundingSphere.center)),xe.applyMatrix4(w.matrixWorld).applyMatrix4(Pe)),Array.isArray(Lt)){let Ht=At.groups;for(let Qt=0,fe=Ht.length;Qt<fe;Qt++){let zt=Ht[Qt],pe=Lt[zt.materialIndex];pe&&pe.visible&&C.push(w,At,pe,K,xe.z,zt,k)}}else Lt.visible&&C.push(w,At,Lt,K,xe.z,null,k)}}}let Et=w.children;for(let It=0,At=Et.length;It<At;It++)gs(Et[It],k,K,q)}function Qo(w,k,K,q){let{opaque:$,transmissive:Et,transparent:It}=w;E.setupLightsView(K),Fe===!0&&nt.setGlobalState(N.clippingPlanes,K),q&&wt.viewport(st.copy(q)),$.length>0&&tn($,k,K),Et.length>0&&tn(Et,k,K),It.length>0&&tn(It,k,K),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Li(w,k,K,q){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[q.id]===void 0){let zt=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[q.id]=new yi(1,1,{generateMipmaps:!0,type:zt?$i:ii,minFilter:Us,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let Et=E.state.transmissionRenderTarget[q.id],It=q.viewport||st;Et.setSize(It.z*N.transmissionResolutionScale,It.w*N.transmissionResolutionScale);let At=N.getRenderTarget(),Lt=N.getActiveCubeFace(),Ht=N.getActiveMipmapLevel();N.setRenderTarget(Et),N.getClearColor(Q),gt=N.getClearAlpha(),gt<1&&N.setClearColor(16777215,.5),N.clear(),Qe&&F.render(K);let Qt=N.toneMapping;N.toneMapping=ds;let fe=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),E.setupLightsView(q),Fe===!0&&nt.setGlobalState(N.clippingPlanes,q),tn(w,K,q),Yt.updateMultisampleRenderTarget(Et),Yt.updateRenderTargetMipmap(Et),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let zt=!1;for(let pe=0,Ze=k.length;pe<Ze;pe++){let Ae=k[pe],{object:Re,geometry:_n,material:Ut,group:hn}=Ae;if(Ut.side===us&&Re.layers.test(q.layers)){let ge=Ut.side;Ut.side=Kn,Ut.needsUpdate=!0,on(Re,K,q,_n,Ut,hn),Ut.side=ge,Ut.needsUpdate=!0,zt=!0}}zt===!0&&(Yt.updateMultisampleRenderTarget(Et),Yt.updateRenderTargetMipmap(Et))}N.setRenderTarget(At,Lt,Ht),N.setClearColor(Q,gt),fe!==void 0&&(q.viewport=fe),N.toneMapping=Qt}function tn(w,k,K){let q=k.isScene===!0?k.overrideMaterial:null;for(let $=0,Et=w.length;$<Et;$++){let It=w[$],{object:At,geometry:Lt,group:Ht}=It,Qt=It.material;Qt.allowOverride===!0&&q!==null&&(Qt=q),At.layers.test(K.layers)&&on(At,k,K,Lt,Qt,Ht)}}function on(w,k,K,q,$,Et){z!==null&&$.isNodeMaterial&&z.setObject(w,$),w.onBeforeRender(N,k,K,q,$,Et),w.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),$.onBeforeRender(N,k,K,q,w,Et),$.transparent===!0&&$.side===us&&$.forceSinglePass===!1?($.side=Kn,$.needsUpdate=!0,N.renderBufferDirect(K,k,q,$,w,Et),$.side=ur,$.needsUpdate=!0,N.renderBufferDirect(K,k,q,$,w,Et),$.side=us):N.renderBufferDirect(K,k,q,$,w,Et),w.onAfterRender(N,k,K,q,$,Et)}function an(w){let k=0;for(let K of w)K.texture!==null&&k++;return k}function Ki(w,k,K){k.isScene!==!0&&(k=gn);let q=Vt.get(w),$=E.state.lights,Et=E.state.shadowsArray,It=$.state.version,At=at.getParameters(w,$.state,Et,k,K,E.state.lightProbeGridArray),Lt=at.getProgramCacheKey(At),Ht=q.programs;q.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?k.environment:null,q.fog=k.fog;let Qt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;q.envMap=R.get(w.envMap||q.environment,Qt),q.envMapRotation=q.environment!==null&&w.envMap===null?k.environmentRotation:w.envMapRotation,Ht===void 0&&(w.addEventListener("dispose",oe),Ht=new Map,q.programs=Ht,q.programVariants=new Map);let fe=Ht.get(Lt);if(fe!==void 0){if(q.currentProgram===fe&&q.lightsStateVersion===It)return ta(w,At),fe}else At.uniforms=at.getUniforms(w),z!==null&&w.isNodeMaterial&&z.build(w,K,At),w.onBeforeCompile(At,N),fe=at.acquireProgram(At,Lt),Ht.set(Lt,fe),q.uniforms=At.uniforms;let zt=q.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(zt.clippingPlanes=nt.uniform),ta(w,At),q.needsLights=zs(w),q.lightsStateVersion=It,q.needsLights&&(zt.ambientLightColor.value=$.state.ambient,zt.lightProbe.value=$.state.probe,zt.sunLights.value=$.state.sun,zt.sunLightShadows.value=$.state.sunShadow,zt.directionalLights.value=$.state.directional,zt.directionalLightShadows.value=$.state.directionalShadow,zt.spotLights.value=$.state.spot,zt.spotLightShadows.value=$.state.spotShadow,zt.rectAreaLights.value=$.state.rectArea,zt.ltc_1.value=$.state.rectAreaLTC1,zt.ltc_2.value=$.state.rectAreaLTC2,zt.pointLights.value=$.state.point,zt.pointLightShadows.value=$.state.pointShadow,zt.hemisphereLights.value=$.state.hemi,zt.sunShadowMatrix.value=$.state.sunShadowMatrix,zt.sunShadowCascade.value=$.state.sunShadowCascade,zt.directionalShadowMatrix.value=$.state.directionalShadowMatrix,zt.spotLightMatrix.value=$.state.spotLightMatrix,zt.spotLightMap.value=$.state.spotLightMap,zt.pointShadowMatrix.value=$.state.pointShadowMatrix),q.numLightProbeGrids=an(E.state.lightProbeGridArray),q.currentProgram=fe,q.uniformsList=null,fe}function oi(w,k,K,q,$){let Et=Vt.get(w),It=Et.currentProgram.id+","+q+","+$,At=Et.programVariants.get(It);return At===void 0?(At=Ki(w,k,K),Et.programVariants.set(It,At)):(Et.currentProgram=At,Et.uniformsList=null,Et.outputColorSpace=q,Et.toneMapping=$),At}function Bs(w){if(w.uniformsList===null){let k=w.currentProgram.getUniforms();w.uniformsList=Zo.seqWithValue(k.seq,w.uniforms)}return w.uniformsList}function ta(w,k){let K=Vt.get(w);K.outputColorSpace=k.outputColorSpace,K.batching=k.batching,K.batchingColor=k.batchingColor,K.instancing=k.instancing,K.instancingColor=k.instancingColor,K.instancingMorph=k.instancingMorph,K.skinning=k.skinning,K.morphTargets=k.morphTargets,K.morphNormals=k.morphNormals,K.morphColors=k.morphColors,K.morphTargetsCount=k.morphTargetsCount,K.numClippingPlanes=k.numClippingPlanes,K.numIntersection=k.numClipIntersection,K.vertexAlphas=k.vertexAlphas,K.vertexTangents=k.vertexTangents,K.toneMapping=k.toneMapping}function ea(w,k,K,q,$){k.isScene!==!0&&(k=gn),Yt.resetTextureUnits();let Et=k.fog,It=q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial?k.environment:null,At=ht===null?N.outputColorSpace:ht.isXRRenderTarget===!0?ht.texture.colorSpace:ye.workingColorSpace,Lt=q.isMeshStandardMaterial||q.isMeshLambertMaterial&&!q.envMap||q.isMeshPhongMaterial&&!q.envMap,Ht=R.get(q.envMap||It,Lt),Qt=q.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,fe=!!K.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),zt=!!K.morphAttributes.position,pe=!!K.morphAttributes.normal,Ze=!!K.morphAttributes.color,Ae=ds;q.toneMapped&&(ht===null||ht.isXRRenderTarget===!0)&&(Ae=N.toneMapping);let Re=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,_n=Re!==void 0?Re.length:0,Ut=Vt.get(q),hn=E.state.lights;if(Fe===!0&&(ln===!0||w!==j)){let Ce=w===j&&q.id===J;nt.setState(q,w,Ce)}let ge=!1,_s=!1;q.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==hn.state.version||$.isBatchedMesh&&Ut.batching===!1||!$.isBatchedMesh&&Ut.batching===!0||$.isBatchedMesh&&Ut.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Ut.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Ut.instancing===!1||!$.isInstancedMesh&&Ut.instancing===!0||$.isSkinnedMesh&&Ut.skinning===!1||!$.isSkinnedMesh&&Ut.skinning===!0||$.isInstancedMesh&&Ut.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Ut.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Ut.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Ut.instancingMorph===!1&&$.morphTexture!==null||Ut.envMap!==Ht||q.fog===!0&&Ut.fog!==Et||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==nt.numPlanes||Ut.numIntersection!==nt.numIntersection)||Ut.vertexAlphas!==Qt||Ut.vertexTangents!==fe||Ut.morphTargets!==zt||Ut.morphNormals!==pe||Ut.morphColors!==Ze||Ut.morphTargetsCount!==_n||Ut.numLightProbeGrids!==an(E.state.lightProbeGridArray)?ge=!0:(Ut.outputColorSpace!==At||Ut.toneMapping!==Ae)&&(_s=!0):(ge=!0,Ut.__version=q.version);let un=Ut.currentProgram;(ge===!0||_s===!0)&&(un=_s===!0?oi(q,k,$,At,Ae):Ki(q,k,$),z&&q.isNodeMaterial&&z.onUpdateProgram(q,un,Ut));let Xr=!1,ji=!1,ys=!1,le=un.getUniforms(),en=Ut.uniforms;if(wt.useProgram(un.program)&&(Xr=!0,ji=!0,ys=!0),q.id!==J&&(J=q.id,ji=!0),Xr||j!==w){wt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),le.setValue(U,"projectionMatrix",w.projectionMatrix),le.setValue(U,"viewMatrix",w.matrixWorldInverse);let dn=le.map.cameraPosition;dn!==void 0&&dn.setValue(U,wn.setFromMatrixPosition(w.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&le.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,ji=!0,ys=!0)}if(Ut.needsLights&&(hn.state.sunShadowMap.length>0&&le.setValue(U,"sunShadowMap",hn.state.sunShadowMap,Yt),hn.state.directionalShadowMap.length>0&&le.setValue(U,"directionalShadowMap",hn.state.directionalShadowMap,Yt),hn.state.spotShadowMap.length>0&&le.setValue(U,"spotShadowMap",hn.state.spotShadowMap,Yt),hn.state.pointShadowMap.length>0&&le.setValue(U,"pointShadowMap",hn.state.pointShadowMap,Yt)),$.isSkinnedMesh){le.setOptional(U,$,"bindMatrix"),le.setOptional(U,$,"bindMatrixInverse");let Ce=$.skeleton;Ce&&(Ce.boneTexture===null&&Ce.computeBoneTexture(),le.setValue(U,"boneTexture",Ce.boneTexture,Yt))}$.isBatchedMesh&&(le.setOptional(U,$,"batchingTexture"),le.setValue(U,"batchingTexture",$._matricesTexture,Yt),le.setOptional(U,$,"batchingIdTexture"),le.setValue(U,"batchingIdTexture",$._indirectTexture,Yt),le.setOptional(U,$,"batchingColorTexture"),$._colorsTexture!==null&&le.setValue(U,"batchingColorTexture",$._colorsTexture,Yt));let Gn=K.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&rt.update($,K,un),(ji||Ut.receiveShadow!==$.receiveShadow)&&(Ut.receiveShadow=$.receiveShadow,le.setValue(U,"receiveShadow",$.receiveShadow)),(q.isMeshStandardMaterial||q.isMeshLambertMaterial||q.isMeshPhongMaterial)&&q.envMap===null&&k.environment!==null&&(en.envMapIntensity.value=k.environmentIntensity),en.dfgLUT!==void 0&&(en.dfgLUT.value=sA()),ji){if(le.setValue(U,"toneMappingExposure",N.toneMappingExposure),Ut.needsLights&&Gr(en,ys),Et&&q.fog===!0&&yt.refreshFogUniforms(en,Et),yt.refreshMaterialUniforms(en,q,Mt,Rt,E.state.transmissionRenderTarget[w.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Ce=S,dn=0;for(let Fn of E.state.lightProbeGridArray)Fn.texture!==null&&(Ce.textures[dn]=Fn.texture,Ce.min[dn]=Fn.boundingBox.min,Ce.max[dn]=Fn.boundingBox.max,Ce.resolution[dn]=Fn.resolution,dn++);for(let Fn in Ce)Ce[Fn].length=dn;en.probesSH.value=Ce.textures,en.probesMin.value=Ce.min,en.probesMax.value=Ce.max,en.probesResolution.value=Ce.resolution}Zo.upload(U,Bs(Ut),en,Yt)}if(q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Zo.upload(U,Bs(Ut),en,Yt),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&le.setValue(U,"center",$.center),le.setValue(U,"modelViewMatrix",$.modelViewMatrix),le.setValue(U,"normalMatrix",$.normalMatrix),le.setValue(U,"modelMatrix",$.matrixWorld),q.uniformsGroups!==void 0){let Ce=q.uniformsGroups;for(let dn=0,Fn=Ce.length;dn<Fn;dn++){let bl=Ce[dn];Wt.update(bl,un),Wt.bind(bl,un)}}return un}function Gr(w,k){w.ambientLightColor.needsUpdate=k,w.lightProbe.needsUpdate=k,w.sunLights.needsUpdate=k,w.sunLightShadows.needsUpdate=k,w.directionalLights.needsUpdate=k,w.directionalLightShadows.needsUpdate=k,w.pointLights.needsUpdate=k,w.pointLightShadows.needsUpdate=k,w.spotLights.needsUpdate=k,w.spotLightShadows.needsUpdate=k,w.rectAreaLights.needsUpdate=k,w.hemisphereLights.needsUpdate=k}function zs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ht},this.setRenderTargetTextures=function(w,k,K){let q=Vt.get(w);q.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Vt.get(w.texture).__webglTexture=k,Vt.get(w.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:K,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,k){let K=Vt.get(w);K.__webglFramebuffer=k,K.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(w,k=0,K=0){ht=w,Y=k,V=K;let q=null,$=!1,Et=!1;if(w){let At=Vt.get(w);if(At.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(U.FRAMEBUFFER,At.__webglFramebuffer),st.copy(w.viewport),ft.copy(w.scissor),dt=w.scissorTest,wt.viewport(st),wt.scissor(ft),wt.setScissorTest(dt),J=-1;return}else if(At.__webglFramebuffer===void 0)Yt.setupRenderTarget(w);else if(At.__hasExternalTextures)Yt.rebindTextures(w,Vt.get(w.texture).__webglTexture,Vt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Qt=w.depthTexture;if(At.__boundDepthTexture!==Qt){if(Qt!==null&&Vt.has(Qt)&&(w.width!==Qt.image.width||w.height!==Qt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Yt.setupDepthRenderbuffer(w)}}let Lt=w.texture;(Lt.isData3DTexture||Lt.isDataArrayTexture||Lt.isCompressedArrayTexture)&&(Et=!0);let Ht=Vt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Ht[k])?q=Ht[k][K]:q=Ht[k],$=!0):w.samples>0&&Yt.useMultisampledRTT(w)===!1?q=Vt.get(w).__webglMultisampledFramebuffer:Array.isArray(Ht)?q=Ht[K]:q=Ht,st.copy(w.viewport),ft.copy(w.scissor),dt=w.scissorTest}else st.copy(Gt).multiplyScalar(Mt).floor(),ft.copy(de).multiplyScalar(Mt).floor(),dt=ae;if(K!==0&&(q=G),wt.bindFramebuffer(U.FRAMEBUFFER,q)&&wt.drawBuffers(w,q),wt.viewport(st),wt.scissor(ft),wt.setScissorTest(dt),$){let At=Vt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+k,At.__webglTexture,K)}else if(Et){let At=k;for(let Lt=0;Lt<w.textures.length;Lt++){let Ht=Vt.get(w.textures[Lt]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Lt,Ht.__webglTexture,K,At)}}else if(w!==null&&K!==0){let At=Vt.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,At.__webglTexture,K)}J=-1};function Wr(w){let k=Vt.get(w);return(k.__readFormat!==w.format||k.__readType!==w.type)&&(k.__readFormat=w.format,k.__readType=w.type,k.__formatReadable=re.textureFormatReadable(w.format),k.__typeReadable=re.textureTypeReadable(w.type)),k}this.readRenderTargetPixels=function(w,k,K,q,$,Et,It,At=0){if(!(w&&w.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Lt=Vt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt){wt.bindFramebuffer(U.FRAMEBUFFER,Lt);try{let Ht=w.textures[At],Qt=Ht.format,fe=Ht.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+At);let zt=Wr(Ht);if(zt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(zt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=w.width-q&&K>=0&&K<=w.height-$&&U.readPixels(k,K,q,$,_t.convert(Qt),_t.convert(fe),Et)}finally{let Ht=ht!==null?Vt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(U.FRAMEBUFFER,Ht)}}},this.readRenderTargetPixelsAsync=async function(w,k,K,q,$,Et,It,At=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Lt=Vt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&It!==void 0&&(Lt=Lt[It],Array.isArray(Lt)&&(Lt=Lt[0])),Lt)if(k>=0&&k<=w.width-q&&K>=0&&K<=w.height-$){wt.bindFramebuffer(U.FRAMEBUFFER,Lt);let Ht=w.textures[At],Qt=Ht.format,fe=Ht.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+At);let zt=Wr(Ht);if(zt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(zt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,pe),U.bufferData(U.PIXEL_PACK_BUFFER,Et.byteLength,U.STREAM_READ),U.readPixels(k,K,q,$,_t.convert(Qt),_t.convert(fe),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Ze=ht!==null?Vt.get(ht).__webglFramebuffer:null;wt.bindFramebuffer(U.FRAMEBUFFER,Ze);let Ae=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await V_(U,Ae,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,pe),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Et),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(pe),U.deleteSync(Ae),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,k=null,K=0){let q=Math.pow(2,-K),$=Math.floor(w.image.width*q),Et=Math.floor(w.image.height*q),It=k!==null?k.x:0,At=k!==null?k.y:0;Yt.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,K,0,0,It,At,$,Et),wt.unbindTexture()},this.copyTextureToTexture=function(w,k,K=null,q=null,$=0,Et=0){let It,At,Lt,Ht,Qt,fe,zt,pe,Ze,Ae=w.isCompressedTexture?w.mipmaps[Et]:w.image;if(K!==null)It=K.max.x-K.min.x,At=K.max.y-K.min.y,Lt=K.isBox3?K.max.z-K.min.z:1,Ht=K.min.x,Qt=K.min.y,fe=K.isBox3?K.min.z:0;else{let le=Math.pow(2,-$);It=Math.floor(Ae.width*le),At=Math.floor(Ae.height*le),w.isDataArrayTexture?Lt=Ae.depth:w.isData3DTexture?Lt=Math.floor(Ae.depth*le):Lt=1,Ht=0,Qt=0,fe=0}q!==null?(zt=q.x,pe=q.y,Ze=q.z):(zt=0,pe=0,Ze=0);let Re=_t.convert(k.format),_n=_t.convert(k.type),Ut;k.isData3DTexture?(Yt.setTexture3D(k,0),Ut=U.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Yt.setTexture2DArray(k,0),Ut=U.TEXTURE_2D_ARRAY):(Yt.setTexture2D(k,0),Ut=U.TEXTURE_2D),wt.activeTexture(U.TEXTURE0),wt.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,k.flipY),wt.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),wt.pixelStorei(U.UNPACK_ALIGNMENT,k.unpackAlignment);let hn=wt.getParameter(U.UNPACK_ROW_LENGTH),ge=wt.getParameter(U.UNPACK_IMAGE_HEIGHT),_s=wt.getParameter(U.UNPACK_SKIP_PIXELS),un=wt.getParameter(U.UNPACK_SKIP_ROWS),Xr=wt.getParameter(U.UNPACK_SKIP_IMAGES);wt.pixelStorei(U.UNPACK_ROW_LENGTH,Ae.width),wt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Ae.height),wt.pixelStorei(U.UNPACK_SKIP_PIXELS,Ht),wt.pixelStorei(U.UNPACK_SKIP_ROWS,Qt),wt.pixelStorei(U.UNPACK_SKIP_IMAGES,fe);let ji=w.isDataArrayTexture||w.isData3DTexture,ys=k.isDataArrayTexture||k.isData3DTexture;if(w.isDepthTexture){let le=Vt.get(w),en=Vt.get(k),Gn=Vt.get(le.__renderTarget),Ce=Vt.get(en.__renderTarget);wt.bindFramebuffer(U.READ_FRAMEBUFFER,Gn.__webglFramebuffer),wt.bindFramebuffer(U.DRAW_FRAMEBUFFER,Ce.__webglFramebuffer);for(let dn=0;dn<Lt;dn++)ji&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Vt.get(w).__webglTexture,$,fe+dn),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Vt.get(k).__webglTexture,Et,Ze+dn)),U.blitFramebuffer(Ht,Qt,Ht+It,Qt+At,zt,pe,zt+It,pe+At,U.DEPTH_BUFFER_BIT,U.NEAREST);wt.bindFramebuffer(U.READ_FRAMEBUFFER,null),wt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if($!==0||w.isRenderTargetTexture||Vt.has(w)){let le=Vt.get(w),en=Vt.get(k);wt.bindFramebuffer(U.READ_FRAMEBUFFER,L),wt.bindFramebuffer(U.DRAW_FRAMEBUFFER,W);for(let Gn=0;Gn<Lt;Gn++)ji?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,le.__webglTexture,$,fe+Gn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,le.__webglTexture,$),ys?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,en.__webglTexture,Et,Ze+Gn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,en.__webglTexture,Et),$!==0?U.blitFramebuffer(Ht,Qt,Ht+It,Qt+At,zt,pe,zt+It,pe+At,U.COLOR_BUFFER_BIT,U.NEAREST):ys?U.copyTexSubImage3D(Ut,Et,zt,pe,Ze+Gn,Ht,Qt,It,At):U.copyTexSubImage2D(Ut,Et,zt,pe,Ht,Qt,It,At);wt.bindFramebuffer(U.READ_FRAMEBUFFER,null),wt.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else ys?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Ut,Et,zt,pe,Ze,It,At,Lt,Re,_n,Ae.data):k.isCompressedArrayTexture?U.compressedTexSubImage3D(Ut,Et,zt,pe,Ze,It,At,Lt,Re,Ae.data):U.texSubImage3D(Ut,Et,zt,pe,Ze,It,At,Lt,Re,_n,Ae):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Et,zt,pe,It,At,Re,_n,Ae.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Et,zt,pe,Ae.width,Ae.height,Re,Ae.data):U.texSubImage2D(U.TEXTURE_2D,Et,zt,pe,It,At,Re,_n,Ae);wt.pixelStorei(U.UNPACK_ROW_LENGTH,hn),wt.pixelStorei(U.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(U.UNPACK_SKIP_PIXELS,_s),wt.pixelStorei(U.UNPACK_SKIP_ROWS,un),wt.pixelStorei(U.UNPACK_SKIP_IMAGES,Xr),Et===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&U.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(w){Vt.get(w).__webglFramebuffer===void 0&&Yt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Yt.setTextureCube(w,0):w.isData3DTexture?Yt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Yt.setTexture2DArray(w,0):Yt.setTexture2D(w,0),wt.unbindTexture()},this.resetState=function(){Y=0,V=0,ht=null,wt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ri}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};var Ry={type:"change"},Dp={type:"start"},Py={type:"end"},Pu=new Nr,Cy=new gi,rA=Math.cos(70*gp.DEG2RAD),Mn=new B,si=2*Math.PI,we={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Lp=1e-6,Iu=class extends sl{constructor(t,e=null){super(t,e),this.state=we.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:cr.ROTATE,MIDDLE:cr.DOLLY,RIGHT:cr.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new _i,this._lastTargetPosition=new B,this._quat=new _i().setFromUnitVectors(t.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Go,this._sphericalDelta=new Go,this._scale=1,this._panOffset=new B,this._rotateStart=new kt,this._rotateEnd=new kt,this._rotateDelta=new kt,this._panStart=new kt,this._panEnd=new kt,this._panDelta=new kt,this._dollyStart=new kt,this._dollyEnd=new kt,this._dollyDelta=new kt,this._dollyDirection=new B,this._mouse=new kt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=aA.bind(this),this._onPointerDown=oA.bind(this),this._onPointerUp=lA.bind(this),this._onContextMenu=mA.bind(this),this._onMouseWheel=uA.bind(this),this._onKeyDown=dA.bind(this),this._onTouchStart=fA.bind(this),this._onTouchMove=pA.bind(this),this._onMouseDown=cA.bind(this),this._onMouseMove=hA.bind(this),this._interceptControlDown=gA.bind(this),this._interceptControlUp=_A.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=we.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ry),this.update(),this.state=we.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Mn.copy(e).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===we.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=si:n>Math.PI&&(n-=si),s<-Math.PI?s+=si:s>Math.PI&&(s-=si),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Pu.origin.copy(this.object.position),Pu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Pu.direction))<rA?this.object.lookAt(this.target):(Cy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Pu.intersectPlane(Cy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Lp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Lp||this._lastTargetPosition.distanceToSquared(this.target)>Lp?(this.dispatchEvent(Ry),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?si/60*this.autoRotateSpeed*t:si/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Mn.setFromMatrixColumn(e,0),Mn.multiplyScalar(-t),this._panOffset.add(Mn)}_panUp(t,e){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(e,1):(Mn.setFromMatrixColumn(e,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(t),this._panOffset.add(Mn)}_pan(t,e){let n=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(si*this._rotateDelta.x/e.clientHeight),this._rotateUp(si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(si*this._rotateDelta.x/e.clientHeight),this._rotateUp(si*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new kt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}};function oA(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function aA(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function lA(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Py),this.state=we.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function cA(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case cr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=we.DOLLY;break;case cr.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=we.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=we.ROTATE}break;case cr.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=we.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=we.PAN}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(Dp)}function hA(i){switch(this.state){case we.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case we.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case we.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function uA(i){this.enabled===!1||this.enableZoom===!1||this.state!==we.NONE||(i.preventDefault(),this.dispatchEvent(Dp),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Py))}function dA(i){this.enabled!==!1&&this._handleKeyDown(i)}function fA(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1){this.state=we.NONE;break}this._handleTouchStartRotate(i),this.state=we.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1){this.state=we.NONE;break}this._handleTouchStartPan(i),this.state=we.TOUCH_PAN;break;default:this.state=we.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=we.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=we.TOUCH_DOLLY_ROTATE;break;default:this.state=we.NONE}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(Dp)}function pA(i){switch(this._trackPointer(i),this.state){case we.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case we.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case we.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case we.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=we.NONE}}function mA(i){this.enabled!==!1&&i.preventDefault()}function gA(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function _A(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var fr=.5555555555555556,ri=1.5,Iy=1.75;var Np=new B(.51*10,0,0),Ly=new B(.2,.24,1).normalize(),[yA,xA]=[1.34*10,.66*10],Lu=class{camera=new Zn(24,2,1,200);#t;constructor(t,e){this.#t=new Iu(this.camera,t),this.#t.enablePan=!1,this.#t.enableZoom=!1,this.#t.minPolarAngle=.25*Math.PI,this.#t.maxPolarAngle=.56*Math.PI,this.#t.minAzimuthAngle=-.35*Math.PI,this.#t.maxAzimuthAngle=.35*Math.PI,this.#t.target.copy(Np),this.#t.addEventListener("change",e),t.style.touchAction="pan-y"}fit(t){this.camera.aspect=t,this.camera.updateProjectionMatrix();let e=this.camera.position.clone().sub(Np);(e.lengthSq()<1e-6||this.camera.position.lengthSq()<1e-6)&&e.copy(Ly),this.#e(e.normalize())}reset(){this.#e(Ly)}#e(t){let e=Math.tan(this.camera.fov*Math.PI/360),n=Math.max(xA,yA/this.camera.aspect)/(2*e);this.camera.position.copy(Np).addScaledVector(t,n),this.#t.update()}};var vA=[1,1.5,2,3,4,5,6,8],[_l,Fp]=[.1,200];function Dy(i,t){if(!(i>0))return 1;let e=Math.min(Math.max(Iy*t/(10*i),_l),Fp),n=10**Math.floor(Math.log10(e)+1e-9);return n*vA.reduce((s,r)=>r*n<=e*(1+1e-9)?r:s,1)}function Ny(i){let t=_l*(Fp/_l)**(i/1e3);return Number(t.toPrecision(2))}function Fy(i){return Math.round(1e3*Math.log(i/_l)/Math.log(Fp/_l))}var Du=class{root=it("div",{class:"hud"});#t=it("p",{class:"hud-trial"});#e=it("p",{class:"hud-time"});#n=it("p",{class:"hud-note"});#s=it("table",{class:"hud-ports"});#i=[];#o=null;#r=-1;#a=[];#l=[];constructor(){this.root.append(it("div",{},this.#t,this.#e,this.#n),this.#s)}show({run:t,trial:e,time:n},s){this.#o!==t&&this.#h(t),this.#r!==e&&this.#c(t,e),rn(this.#t,`Trial ${e} of ${t.picture.trials}`),rn(this.#e,`t = ${n.toFixed(t.picture.duration<.1?5:3)} s`),rn(this.#n,s);let r=t.trial(e);this.#i.forEach((o,a)=>{rn(o.motion,r?this.#a[a].text(r.at("y",a,n)):"…"),rn(o.effort,r?this.#l[a].text(r.at("delivered",a,n)):"…")})}#h(t){this.#o=t,this.#r=-1,this.#i=t.ports.map(()=>({motion:it("td",{}),effort:it("td",{})})),this.#s.replaceChildren(it("caption",{class:"unseen"},"Motion and delivered effort at the moment"),it("tbody",{},...t.ports.map((e,n)=>this.#u(t,e,n))))}#c(t,e){this.#r=e,this.#a=t.ports.map((n,s)=>new Je(t.largest("y",s,e),n.motion_unit)),this.#l=t.ports.map((n,s)=>new Je(t.largest("delivered",s,e),n.effort_unit))}#u(t,e,n){let{motion:s,effort:r}=this.#i[n],o=it("span",{class:"key"});return o.style.background=`var(--${is(t.ports,n).token})`,it("tr",{},it("th",{scope:"row"},o,fa(e)),s,it("th",{scope:"row"},$s(e)),r)}};function Nu(i){return`deflection × ${Oi(i,i<10?2:3).replace(/\.0+$/,"")}`}var[Op,Oy,yl]=[.055,.16,.34],ky=.02,Fu=class i{static LONGEST=1.9;group=new Ke;#t;#e;#n;constructor(t,e){this.#n=t,this.#t=new Xe(new rr(Op,Op,1,12).translate(0,.5,0),e),this.#e=new Xe(new Bo(Oy,yl,16).translate(0,yl/2,0),e),this.group.add(this.#t,this.#e)}take(t,e,n){let s=Math.abs(n);if(this.group.visible=s>ky,!this.group.visible)return;let r=n>0?1:-1,o=s*i.LONGEST,a=Math.min(1,o/yl),l=o-a*yl;this.group.position.set(t,e+r*this.#n,0),this.group.rotation.z=r>0?0:Math.PI,this.#t.visible=l>0,this.#t.scale.set(a,Math.max(l,.001),a),this.#e.position.y=l,this.#e.scale.setScalar(a)}},[Uu,By,zy,Up,Uy]=[.82,5/6*Math.PI,1.4*Math.PI,60,8],bA=new zo(Array.from({length:37},(i,t)=>{let e=By+t/36*zy;return new B(Uu*Math.cos(e),Uu*Math.sin(e),0)})),Ou=class{group=new Ke;#t;#e;constructor(t){this.#t=new Ka(bA,Up,Op,Uy),this.#e=new Xe(new Bo(Oy,yl,16),t),this.group.add(new Xe(this.#t,t),this.#e),this.group.position.z=ri/2+.2}take(t,e,n){let s=Math.abs(n);if(this.group.visible=s>ky,!this.group.visible)return;let r=Math.max(1,Math.round(s*Up));this.#t.setDrawRange(0,r*Uy*6);let o=By+r/Up*zy;this.#e.position.set(Uu*Math.cos(o),Uu*Math.sin(o),0),this.#e.rotation.z=o,this.#e.scale.setScalar(Math.min(1,.4+2*s)),this.group.position.x=t,this.group.position.y=e,this.group.rotation.y=n>0?0:Math.PI}};var ku=fr/2,Hr=ri/2,Bu=[{edges:[[1,1],[1,-1]],turned:1,out:0},{edges:[[-1,-1],[-1,1]],turned:-1,out:0},{edges:[[-1,1],[1,1]],turned:0,out:1},{edges:[[1,-1],[-1,-1]],turned:0,out:-1}],Hy=.03,zu=class{group=new Ke;#t;#e;#n=new je;#s=new je;#i=new je;constructor(t,e){this.#t=t.x.length,this.#e=Math.max(1,Math.round(this.#t/26));let n=this.#t*2;this.#n.setAttribute("position",pr(Bu.length*n)),this.#n.setAttribute("normal",pr(Bu.length*n)),this.#n.setIndex(Bu.flatMap((s,r)=>Vy(this.#t,r*n))),this.#s.setAttribute("position",pr(4*Math.ceil(this.#t/this.#e))),this.#i.setAttribute("position",pr(n)),this.#i.setIndex(Vy(this.#t,0)),this.group.add(new Xe(this.#n,e.body),new ls(this.#s,e.section),new Xe(this.#i,e.centre));for(let s of this.group.children)s.frustumCulled=!1}take({x:t,y:e,angle:n}){let s=this.#n.getAttribute("position"),r=this.#n.getAttribute("normal"),o=this.#s.getAttribute("position"),a=this.#i.getAttribute("position"),l=0;for(let{edges:c,turned:h,out:u}of Bu)for(let d=0;d<this.#t;d++){let[f,p]=[Math.sin(n[d]),Math.cos(n[d])];for(let[x,g]of c)s.setXYZ(l,t[d]-x*ku*f,e[d]+x*ku*p,g*Hr),r.setXYZ(l++,-h*f,h*p,u)}for(let c=0,h=0;c<this.#t;c+=this.#e,h+=4){let[u,d]=[ku*Math.sin(n[c]),ku*Math.cos(n[c])];o.setXYZ(h,t[c]+u,e[c]-d,Hr),o.setXYZ(h+1,t[c]-u,e[c]+d,Hr),o.setXYZ(h+2,t[c]-u,e[c]+d,Hr),o.setXYZ(h+3,t[c]-u,e[c]+d,-Hr)}for(let c=0;c<this.#t;c++){let[h,u]=[Hy*Math.sin(n[c]),Hy*Math.cos(n[c])];a.setXYZ(2*c,t[c]+h,e[c]-u,Hr+.01),a.setXYZ(2*c+1,t[c]-h,e[c]+u,Hr+.01)}for(let c of[s,r,o,a])c.needsUpdate=!0}};function pr(i){return new Ci(new Float32Array(3*i),3).setUsage(hp)}function Vy(i,t){let e=[];for(let n=0;n<i-1;n++){let[s,r]=[t+2*n,t+2*n+1];e.push(s,s+2,r+2,s,r+2,r)}return e}var Hu=class{line;#t=new je;constructor(t,e){this.#t.setAttribute("position",pr(2*t.x.length)),this.line=new Ga(this.#t,e.ghost),this.line.frustumCulled=!1,this.line.renderOrder=1}take({x:t,y:e,angle:n}){let s=this.#t.getAttribute("position"),r=t.length;for(let o=0;o<r;o++){let[a,l]=[fr/2*Math.sin(n[o]),fr/2*Math.cos(n[o])];s.setXYZ(o,t[o]-a,e[o]+l,ri/2),s.setXYZ(2*r-1-o,t[o]+a,e[o]-l,ri/2)}s.needsUpdate=!0}dispose(){this.#t.dispose()}};var xl=class{x;y;angle;turns;bends;#t;#e;#n;constructor(t){let{fields:e,span:n}=t.picture;this.#n=10/n,this.#t=e.find(({unit:s})=>s==="m")?.name??null,this.#e=e.find(({unit:s})=>s==="rad")?.name??null,this.bends=this.#t!==null&&t.x.length>1,this.turns=this.bends&&this.#e!==null,this.x=this.bends?t.x.map(s=>s*this.#n):Float32Array.of(0,10),this.y=new Float32Array(this.x.length),this.angle=new Float32Array(this.x.length)}take(t,e,n){if(!this.#t||!this.bends)return;let{x:s,y:r,angle:o}=this;t.shape(this.#t,e,r);for(let l=0;l<r.length;l++)r[l]*=n*this.#n;if(this.#e){t.shape(this.#e,e,o);for(let l=0;l<o.length;l++)o[l]=Math.atan(n*o[l]);return}let a=r.length-1;for(let l=0;l<=a;l++){let[c,h]=[l>0?l-1:0,l<a?l+1:a];o[l]=Math.atan((r[h]-r[c])/(s[h]-s[c]))}}heightAt(t){return this.#s(this.y,t)}angleAt(t){return this.#s(this.angle,t)}#s(t,e){let{x:n}=this,s=1;for(;s<n.length-1&&n[s]<e;)s++;let r=n[s-1],o=Math.min(Math.max((e-r)/(n[s]-r),0),1);return t[s-1]*(1-o)+t[s]*o}};function Gy(i,t){let e=new Ke;return e.add(new Xe(i,t.block),new ls(new Fr(i,30),t.edge)),e}function kp(i,t,e,n){return Gy(new cs(i,t,e),n)}function SA(i,t,e){let n=Gy(new rr(i,i,t,40).rotateX(Math.PI/2),e),s=t/2+.01,r=[0,1,2,3].flatMap(o=>{let[a,l]=[Math.cos(o*Math.PI/2),Math.sin(o*Math.PI/2)];return[.25*i*a,.25*i*l,s,.85*i*a,.85*i*l,s]});return n.add(mr(r,e.edge)),n}function mr(i,t){return new ls(new je().setAttribute("position",new Oe(i,3)),t)}function Bp(i,t,e,n,s,r){let o=[];for(let a=r-n;a<e;a+=r){let[l,c]=[Math.max(a,0),Math.min(a+n,e)];c>l&&o.push(i+l,t+l-a,s,i+c,t+c-a,s)}return o}function Wy(i,t){let e=new Ke;if(i==="clamped"){let[n,s,r]=[.8,2.2,1.35*ri],o=kp(n,s,r,t);o.position.x=-n/2,e.add(o,mr(Bp(-n,-s/2,n,s,r/2+.01,.24),t.faint))}else i==="pinned"&&e.add(SA(.62,1.15*ri,t));return e}var MA=3.4,[zp,Vu,Xy]=[2.6,.09,1.5*ri],Gu=class{group=new Ke;#t;#e;#n;constructor(t,e,n){this.#n=e,this.#t=Yy(-1,n),this.#e=Yy(1,n),this.group.add(this.#t,this.#e),this.group.position.x=t}get seen(){return[this.#t,this.#e].some(({visible:t,position:e})=>t&&Math.abs(e.y)<MA)}take(t,e){qy(this.#t,t-this.#n),qy(this.#e,e+this.#n)}};function qy(i,t){i.visible=Math.abs(t)<40,i.visible&&(i.position.y=t)}function Yy(i,t){let e=new Ke,n=new cs(zp,Vu,Xy).translate(0,i*Vu/2,0),s=Bp(-zp/2,i>0?Vu:-Vu-.24,zp,.24,Xy/2,.2);return e.add(new Xe(n,t.wall),new ls(new Fr(n),t.limit),mr(s,t.limit)),e}var[$y,Zy,Wu]=[.95,1.55,33],Xu=class{group=new Ke;#t=new je;#e=new Ke;constructor(t){this.#t.setAttribute("position",pr(Wu+2));let e=new Ns(this.#t,t.limit);e.frustumCulled=!1,this.#e.add(mr([.3,0,0,Zy-.08,0,0],t.needle)),this.group.add(e,this.#e),this.group.position.z=ri/2+.1}take(t,e,n,s,r){this.group.position.x=t,this.group.position.y=e,this.#e.rotation.z=r;let o=this.#t.getAttribute("position"),a=(l,c,h)=>o.setXYZ(l,c*Math.cos(h),c*Math.sin(h),0);a(0,$y,n);for(let l=0;l<Wu;l++)a(l+1,Zy,n+l/(Wu-1)*(s-n));a(Wu+1,$y,s),o.needsUpdate=!0}};function Ky({picture:i,x:t}){return JSON.stringify([i.ports,i.fields,i.span,i.tip,i.clamped,t.length])}var qu=class{group=new Ke;shape;#t;#e;#n;#s;#i;#o;#r=null;constructor(t,e){let{ports:n,span:s,tip:r,clamped:o}=t.picture;this.#o=e,this.#i=10/s,this.shape=new xl(t),this.#t=this.shape.bends?new zu(this.shape,e):null,this.#e=Wy(o,e);let a=fr*Math.min(3,1.25+.65*Math.cbrt(r.mass));this.#n=r.mass>0?kp(a,a,1.7*a,e):null,this.#s=n.map((h,u)=>{let d=h.x*this.#i,f=(this.#n&&h.x>.99*s?a:fr)/2,p=h.motion_unit==="rad";return{port:h,index:u,x:d,carrier:n.findIndex(x=>x.motion_unit==="m"&&x.x===h.x),arrow:h.kind==="force"?new Fu(f,p?e.rotation:e.displacement):new Ou(e.rotation),walls:p||!Jy(t,u)?null:new Gu(d,f,e),wedge:p&&Jy(t,u)?new Xu(e):null,dot:this.shape.bends?null:new Xe(new Ja(.2,24,16),p?e.rotation:e.displacement)}});let c=[mr([0,0,0,10+1.2,0,0],e.axis),this.#t?.group,this.#e,this.#n];for(let{arrow:h,walls:u,wedge:d,dot:f}of this.#s)c.push(h.group,u?.group,d?.group,f);this.group.add(...c.filter(h=>h!=null))}take(t,e,n,s){let{shape:r}=this;r.take(e,n,s),this.#t?.take(r),t.picture.clamped==="pinned"&&(this.#e.rotation.z=r.angleAt(0));let o=this.#n;o&&(o.position.set(10,this.#l(e,n,s),0),o.rotation.z=r.angleAt(10));for(let{index:a,x:l,carrier:c,arrow:h,walls:u,wedge:d,dot:f}of this.#s){let p=r.bends||c<0?r.heightAt(l):this.#a(e,c,n,s),x=t.largest("delivered",a,null);h.take(l,p,x>0?e.at("delivered",a,n)/x:0);let g=e.at("low",a,n),m=e.at("high",a,n);u?.take(g*s*this.#i,m*s*this.#i),d?.take(l,p,Math.atan(s*g),Math.atan(s*m),Math.atan(s*e.at("y",a,n))),f?.position.set(l,p,0)}}get beyond(){let t=this.#s.flatMap(e=>e.walls??[]);return t.length>0&&!t.some(({seen:e})=>e)}haunt(t,e,n,s){if(this.#r&&this.#r.run!==t&&(this.group.remove(this.#r.outline.line),this.#r.outline.dispose(),this.#r=null),!!t){if(!this.#r){let r=new xl(t);if(!r.bends)return;this.#r={run:t,shape:r,outline:new Hu(r,this.#o)},this.group.add(this.#r.outline.line)}this.#r.outline.line.visible=e!==null,e&&(this.#r.shape.take(e,n,s),this.#r.outline.take(this.#r.shape))}}dispose(){this.group.traverse(t=>{(t instanceof Xe||t instanceof Ns)&&t.geometry.dispose()})}#a(t,e,n,s){return t.at("y",e,n)*s*this.#i}#l(t,e,n){if(this.shape.bends)return this.shape.heightAt(10);let s=this.#s.find(({port:r,x:o})=>r.motion_unit==="m"&&o>.99*10);return s?this.#a(t,s.index,e,n):0}};function Jy(i,t){return i.largest("low",t,null)>0||i.largest("high",t,null)>0}var Yu=class{body=new Ho({polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});block=new Ho({polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1});edge=new Pi;faint=new Pi({transparent:!0,opacity:.5});axis=new Pi;section=new Pi({transparent:!0,opacity:.8});centre=new Ds;limit=new Pi;wall=new Ds({transparent:!0,opacity:.22,depthWrite:!1});ghost=new Pi({depthTest:!1,transparent:!0});displacement=new Ds;rotation=new Ds;needle=new Pi;take(t,e){let n=r=>new he(t.colour(r)),s=r=>n("paper").lerp(n("ink"),r);this.body.color.copy(s(t.dark?.3:.13)),this.block.color.copy(s(t.dark?.2:.34)),this.edge.color.copy(s(t.dark?.5:.6)),this.faint.color.copy(n("faint")),this.axis.color.copy(s(.24)),this.section.color.copy(e?n("rotation"):s(.5)),this.centre.color.copy(n("displacement")),this.limit.color.copy(n("constraint")),this.wall.color.copy(n("constraint")),this.ghost.color.copy(n("faint")),this.displacement.color.copy(n("displacement")),this.rotation.color.copy(n("rotation")),this.needle.color.copy(n("rotation"))}};var $u=class{root=it("div",{class:"stage-tools"});#t=it("input",{type:"range",min:"0",max:"1000",attributes:{"aria-label":"Exaggeration of deflections"}});#e=it("input",{type:"checkbox"});#n=it("span",{class:"times"});#s=1;constructor({exaggerate:t,reset:e}){this.#t.oninput=()=>t(Ny(Number(this.#t.value))),this.#e.onchange=()=>t(this.#e.checked?0:this.#s);let n=it("button",{type:"button",onclick:e},"Reset view");this.root.append(this.#n,this.#t,it("label",{},this.#e," auto"),n)}show(t,e){if(this.#e.checked=e,t===this.#s&&this.#n.textContent)return;this.#s=t;let n=Nu(t);rn(this.#n,n),this.#t.setAttribute("aria-valuetext",n),(document.activeElement!==this.#t||e)&&(this.#t.value=String(Fy(t)))}};var Zu=class{#t;#e=new Du;#n;#s=it("div",{class:"stage-view"});#i=new Yu;#o=new za;#r;#a=null;#l=null;#h="";#c=null;#u=1;#f=0;#p=0;#m=!0;#g=!0;constructor(t,e,n){if(this.#t=e,this.#n=new $u({exaggerate:n,reset:()=>this.#y()}),t.append(this.#e.root,this.#s,this.#n.root),this.#r=TA(),this.#r){let s=this.#r.domElement;s.setAttribute("role","img"),this.#a=new Lu(s,()=>this.#d());let r=new il(16777215,1.7);r.position.set(3,8,6),this.#o.add(new tl(16777215,13159634,1.9),r),this.#s.append(s),new ResizeObserver(()=>this.#S()).observe(this.#s),new IntersectionObserver(o=>{this.#m=o.at(-1)?.isIntersecting??!0,this.#m&&this.#d()}).observe(this.#s)}else this.#s.append(it("p",{class:"stage-without"},"This browser offers no WebGL, so the moving structure cannot be drawn; everything else works."))}show(t,e,n){this.#c=t,this.#g||=n,this.#f=e,this.#d()}repaint(){this.#i.take(this.#t,this.#l?.shape.turns??!1),this.#d()}#y(){this.#a?.reset(),this.#d()}#d(){this.#p||(this.#p=requestAnimationFrame(()=>this.#_()))}#_(){this.#p=0;let t=this.#c;if(!t||!this.#m)return;let e=t.run.trial(t.trial);e&&(this.#u=this.#f||wA(t)),this.#n.show(this.#u,this.#f===0),this.#r&&this.#a&&this.#x(t,e,this.#r,this.#a),this.#g&&(this.#g=!1,e?this.#e.show(t,this.#l?.beyond?"walls out of view":""):this.#e.show(t,`waiting for trial ${t.trial} …`))}#x(t,e,n,{camera:s}){this.#v(t),e&&this.#l?.take(t.run,e,t.time,this.#u);let r=t.pinned?.run??null;this.#l?.haunt(r,r?.trial(t.trial)??null,Math.min(t.time,r?.picture.duration??0),this.#u),n.render(this.#o,s),this.#b(t,n.domElement)}#v({run:t}){let e=Ky(t);e!==this.#h&&(this.#h=e,this.#l&&(this.#o.remove(this.#l.group),this.#l.dispose()),this.#l=new qu(t,this.#i),this.#i.take(this.#t,this.#l.shape.turns),this.#o.add(this.#l.group))}#S(){let{clientWidth:t,clientHeight:e}=this.#s;!this.#r||t===0||e===0||(this.#r.setPixelRatio(Math.min(devicePixelRatio,1.5)),this.#r.setSize(t,e,!1),this.#a?.fit(t/e),this.#d())}#b({run:t,trial:e},n){let s=t.picture.fields.find(({unit:a})=>a==="m"),r=s?t.largestOfField(s.name,e):0,o=s?`, which deflects by at most ${new Je(r,"m").text(r)}`:"";Qn(n,`The structure in motion in trial ${e}${o}; drawn with ${Nu(this.#u)}.`)}};function wA({run:i,trial:t}){let e=i.picture.fields.find(({unit:s})=>s==="m"),n=i.ports.map((s,r)=>s.motion_unit==="m"?i.largest("y",r,t):0);return Dy(Math.max(e?i.largestOfField(e.name,t):0,...n),i.picture.span)}function TA(){try{let i=new Au({antialias:!0,alpha:!0,powerPreference:"low-power"});return i.setClearAlpha(0),i}catch{return null}}var jy="http://www.w3.org/2000/svg",EA={play:"M5 3l9 6l-9 6z",pause:"M5 3h3v12h-3z M11 3h3v12h-3z",back:"M12 4l-6 5l6 5z M4 4h1.6v10h-1.6z",on:"M6 4l6 5l-6 5z M12.4 4h1.6v10h-1.6z",previous:"M11 4l-5 5l5 5",next:"M7 4l5 5l-5 5"},AA=new Set(["previous","next"]);function Ko(i,t,e){let n=i==="play"?[Hp("play"),Hp("pause")]:[Hp(i)];return it("button",{type:"button",class:"icon",title:t,onclick:e,attributes:{"aria-label":t}},...n)}function Hp(i){let t=document.createElementNS(jy,"svg"),e=document.createElementNS(jy,"path"),n={viewBox:"0 0 18 18",width:"18",height:"18","aria-hidden":"true",class:`sign-${i}${AA.has(i)?" open":""}`};for(let[s,r]of Object.entries(n))t.setAttribute(s,r);return e.setAttribute("d",EA[i]),t.append(e),t}var Qy=[[1/50,"1/50"],[1/20,"1/20"],[1/10,"1/10"],[1/4,"1/4"],[1/2,"1/2"],[1,"1"],[2,"2"]],Ju=class{#t;#e=it("input",{type:"range",min:"0",step:"any",class:"scrub",attributes:{"aria-label":"Time"}});#n=it("span",{class:"time"});#s=it("select",{},...Qy.map(([t,e])=>it("option",{value:String(t)},`${e} × real time`)));#i=it("input",{type:"range",min:"0",step:"1",attributes:{"aria-label":"Trial"}});#o=it("input",{type:"number",min:"0",step:"1",attributes:{"aria-label":"Number of the trial"}});#r=it("span",{class:"faint"});#a;constructor(t,e){this.#t=Ko("play","Play (space)",()=>e.play(this.#t.dataset.playing!=="true")),this.#t.classList.add("play"),this.#e.oninput=()=>e.seek(Number(this.#e.value)),this.#s.onchange=()=>e.speed(Number(this.#s.value)),this.#i.oninput=()=>e.jump(Number(this.#i.value)),this.#o.onchange=()=>e.jump(Number(this.#o.value));let n=o=>()=>e.jump(Number(this.#i.value)+o),s=o=>it("input",{type:"radio",name:"span",value:o,onchange:()=>e.span(o)});this.#a={trial:s("trial"),run:s("run")};let r=it("div",{class:"transport"});t.append(r),r.append(it("div",{class:"transport-row"},Ko("back","A snapshot back (,)",()=>e.step(-1)),this.#t,Ko("on","A snapshot on (.)",()=>e.step(1)),this.#e,this.#n),it("div",{class:"transport-row"},it("div",{class:"trials"},it("span",{},"Trial"),Ko("previous","Trial before ([)",n(-1)),this.#i,Ko("next","Next trial (])",n(1)),this.#o,this.#r),it("fieldset",{class:"spans"},it("legend",{class:"unseen"},"What the plots show"),it("label",{},this.#a.trial,it("span",{},"this trial")),it("label",{},this.#a.run,it("span",{},"whole run"))),it("label",{class:"speed"},it("span",{},"Speed "),this.#s)))}show(t,e,n){let{run:s,trial:r,span:o}=t,{trials:a,duration:l,steps:c}=s.picture,h=Math.max(1,(s.trial(r)?.snapshots||c+1)-1),u=Hi({...t,pinned:null});gr(this.#e,"max",String(u)),gr(this.#e,"step",String(l/h)),gr(this.#e,"value",String(Ei(t))),gr(this.#i,"max",String(a-1)),gr(this.#i,"value",String(r)),gr(this.#o,"max",String(a-1)),document.activeElement!==this.#o&&gr(this.#o,"value",String(r)),rn(this.#r,`of ${a}, from 0`);let d=`${Ei(t).toFixed(l<.1?5:3)} s`;rn(this.#n,`${d} of ${Number(u.toFixed(6))} s`),this.#e.setAttribute("aria-valuetext",`${d}, trial ${r}`),this.#i.setAttribute("aria-valuetext",`trial ${r} of ${a}`),this.#a[o].checked=!0;let f=Qy.reduce((p,x)=>Math.abs(x[0]-n)<Math.abs(p[0]-n)?x:p);gr(this.#s,"value",String(f[0])),this.#t.dataset.playing!==String(e)&&(this.#t.dataset.playing=String(e),this.#t.setAttribute("aria-label",e?"Pause (space)":"Play (space)"),this.#t.title=e?"Pause (space)":"Play (space)")}};function gr(i,t,e){(t==="value"?i.value!==e:i.getAttribute(t)!==e)&&(t==="value"?i.value=e:i.setAttribute(t,e))}var tx={FAIL:0,PASS:1,note:2,"n/a":3},Ku=class{#t;constructor(t){this.#t=t,t.classList.add("verdicts")}show(t){if(this.#t.classList.toggle("pending",t===null),this.#t.setAttribute("aria-busy",String(t===null)),t===null){this.#t.firstChild||this.#t.append(it("p",{class:"faint"},"The run is being reviewed …"));return}let e=new Set([...this.#t.querySelectorAll("details[data-section]")].filter(n=>n.open).map(n=>n.dataset.section));this.#t.replaceChildren(it("h2",{},"Verdict"),it("p",{class:"verdict"},Yn(t.verdict)),...t.claims.length>0?[RA(t.claims)]:[],...t.findings.length>0?[it("h3",{},"Audit"),...t.audit?[it("p",{class:"card-caption"},Yn(t.audit))]:[]]:[],...CA(t.findings).map(([n,s])=>PA(n,s,e.has(n))))}};function RA(i){let t=["Claim","Statement","Measured","Verdict"].map(e=>it("th",{scope:"col"},e));return it("table",{class:"claims"},it("caption",{class:"unseen"},"Claims of the scenario"),it("thead",{},it("tr",{},...t)),it("tbody",{},...i.map(e=>it("tr",{},it("th",{scope:"row"},e.id),it("td",{},Yn(e.statement),...ex(e)),it("td",{class:"measured"},Yn(e.measured)),it("td",{},nx(e.verdict))))))}function CA(i){let t=new Map;for(let e of i)t.set(e.section,[...t.get(e.section)??[],e]);return[...t]}function PA(i,t,e){let n=t.filter(({verdict:l})=>l==="PASS"||l==="FAIL"),s=n.filter(({verdict:l})=>l==="PASS").length,r=s<n.length,o=n.length===0?"nothing to be judged":`${s} of ${n.length} hold`,a=[...t].sort((l,c)=>tx[l.verdict]-tx[c.verdict]);return it("details",{class:"findings",open:e||r,attributes:{"data-section":i}},it("summary",{},it("span",{},Yn(i)),it("span",{class:r?"count bad":"count"},o)),it("ul",{},...a.map(IA)))}function IA(i){return it("li",{class:i.verdict==="note"||i.verdict==="n/a"?"subdued":""},nx(i.verdict),it("div",{},it("span",{class:"finding-statement"},Yn(i.statement))," ",it("span",{class:"measured"},Yn(i.measured)),...ex(i)))}function ex({criterion:i}){return i?[it("div",{class:"criterion"},Yn(i))]:[]}function nx(i){let t={PASS:"✓ PASS",FAIL:"✗ FAIL",note:"note","n/a":"n/a"};return it("span",{class:`badge ${i==="n/a"?"na":i.toLowerCase()}`},t[i])}var LA=60,DA=.1,ju=class{#t;#e=new Kl;#n;#s;#i;#o;#r;#a=new WeakSet;#l=null;#h=null;#c=0;#u=0;#f=-1/0;constructor(t,e,n){this.#t=n;let s=matchMedia("(prefers-reduced-motion: reduce)").matches;this.#r={trial:0,time:0,exaggeration:0,speed:.25,span:"trial",playing:!s};let r=c=>this.#m(c),o=c=>this.#g(c),a=c=>this.#y(c),l=c=>this.#d({playing:c});this.#n=new Zu(t.stage,this.#e,c=>this.#d({exaggeration:c})),this.#s=new Ju(t.transport,{play:l,step:a,seek:r,jump:o,speed:c=>this.#d({speed:c}),span:c=>this.#d({span:c})}),this.#i=new wc(t.panels,{look:this.#e,seek:r,jump:o}),this.#o=new Ku(t.verdicts),C0({" ":()=>l(!this.#r.playing),",":()=>a(-1),".":()=>a(1),"[":()=>o(this.#r.trial-1),"]":()=>o(this.#r.trial+1)})}get state(){return{...this.#r}}set state(t){this.#_(t)}async show(t){this.#l=t,this.#_({},!0),document.hidden||await new Promise(e=>requestAnimationFrame(e))}more(t){let e=this.#p();!e||t!==this.#l&&t!==this.#h?.run||t.has(e.trial)&&!this.#a.has(t)&&this.#x(e)}pin(t,e){this.#h=t&&{run:t,label:e};let n=this.#p();n&&this.#x(n)}review(t){this.#o.show(t)}colours(t){this.#e.read(t),this.#n.repaint(),this.#i.repaint()}#p(){let{trial:t,time:e,span:n}=this.#r;return this.#l&&{run:this.#l,pinned:this.#h,trial:t,time:e,span:n}}#m(t){if(!this.#l)return;let{trials:e,duration:n}=this.#l.picture;this.#r.span==="run"?this.#d(km(t,e,n)):this.#d({time:Math.min(Math.max(t,0),n)})}#g(t){!this.#l||!Number.isFinite(t)||this.#d({trial:Math.min(Math.max(Math.round(t),0),this.#l.picture.trials-1)})}#y(t){if(!this.#l)return;let{trials:e,duration:n,steps:s}=this.#l.picture,r=Math.max(1,(this.#l.trial(this.#r.trial)?.snapshots||s+1)-1),o=Math.round(this.#r.time/n*r)+t;o>=0&&o<=r?this.#d({playing:!1,time:o/r*n}):this.#d({playing:!1,...Md({trial:this.#r.trial,time:t>0?n:0},t>0?0:e*n-1e-9,e,n)})}#d(t){this.#_(t),this.#t.state()}#_(t,e=!1){let n={...this.#r};Object.assign(this.#r,t);let s=this.#l;if(!s)return;this.#r.trial=Math.min(this.#r.trial,Math.max(s.picture.trials-1,0)),this.#r.time=Math.min(this.#r.time,s.picture.duration),s.looked=this.#r.trial;let r=n.trial!==this.#r.trial,o=this.#p();(e||r||n.playing!==this.#r.playing)&&(this.#f=-1/0),e||r||n.span!==this.#r.span?this.#x(o):this.#v(o),(r||e&&!s.has(this.#r.trial))&&this.#t.trial(this.#r.trial),this.#S()}#x(t){for(let e of[t.run,t.pinned?.run])e?.has(t.trial)?this.#a.add(e):e&&this.#a.delete(e);this.#i.draw(t),this.#v(t)}#v(t){let e=performance.now(),n=!this.#r.playing||e-this.#f>LA;n&&(this.#f=e),this.#n.show(t,this.#r.exaggeration,n),n&&this.#s.show(t,this.#r.playing,this.#r.speed),this.#i.cursor(t)}#S(){this.#r.playing&&!this.#c&&(this.#u=performance.now(),this.#c=requestAnimationFrame(t=>this.#b(t)))}#b(t){this.#c=0;let e=this.#l;if(!e||!this.#r.playing)return;let n=Math.min(Math.max(t-this.#u,0)/1e3,DA)*this.#r.speed;this.#u=t;let{trials:s,duration:r}=e.picture;e.has(this.#r.trial)&&s>0&&this.#_(Md(this.#r,n,s,r)),this.#c||=requestAnimationFrame(o=>this.#b(o))}};var NA={toml:"Writing the scenario.",netcdf:"Writing the result.",figures:"Drawing the figures; this takes a few seconds.",report:"Making the report; this takes a few seconds."},Qu=class{constructor(t,e,n){this.schema=t;this.start=e;this.scenario=new Vl(e,()=>this.changed());let s={stage:Un("stage"),transport:Un("transport"),panels:Un("panels"),verdicts:Un("verdicts")};this.view=new ju(s,t,{trial:r=>this.session.look(r),state:()=>this.address.renew()}),this.address=new wl(()=>{let{preset:r,table:o}=this.scenario;return{v:1,preset:r.name,table:o,view:this.view.state}}),this.session=new Zl(this.view,{drawn:r=>this.drawn(r),pinned:r=>this.nowPinned(r),refused:r=>this.refused(r,"Not run"),failed:r=>this.failed(r),note:r=>this.status.say(r),line:r=>this.status.line(r)}),this.panel=new Hl(Un("controls"),new Tl(t,this.scenario,Tm)),this.bar=new Wl(Un("bar"),t,this.actions,n),this.refreshBar()}schema;start;status=new Xl;scenario;view;session;panel;bar;address;pinned=null;async begin(){await this.follow(t=>{let{preset:e,table:n}=t??{preset:this.start,table:this.start.table};this.scenario.begin(e,n)})}async navigate(){await this.follow(t=>t&&this.scenario.open(t.preset,t.table))}colours(t){this.view.colours(t)}undo(){this.scenario.undo()}redo(){this.scenario.redo()}async open(t){this.status.say(`Reading ${t.name}.`),await this.attempt("Not read",async()=>this.scenario.open(await wm(t)))}actions={preset:t=>{this.attempt("Not opened",async()=>this.scenario.open(await md(t)))},undo:()=>this.undo(),redo:()=>this.redo(),pin:()=>this.session.pin(this.session.now),unpin:()=>this.session.pin(null),swap:()=>this.swap(),beside:()=>this.besideNoControl(),share:()=>{this.share()},download:t=>{this.save(t)},open:t=>{this.open(t)}};changed(){Jl("dampen:changed",this.session.run(this.source())),this.status.expect(),this.panel.update(),this.refreshBar(),this.address.renew()}drawn(t){this.panel.learn(t),this.panel.show([]),this.status.picture(t),this.refreshBar()}nowPinned(t){this.pinned=t,this.status.say(t===null?"Nothing is pinned.":`Pinned: ${t}.`),this.refreshBar()}refused(t,e){this.panel.show(t),this.status.faults(t,e)}failed(t){this.status.say("Not run.",!0),this.status.tell(t)}source(){let{preset:t,table:e}=this.scenario,n=Si(e,t.table)?t.token:void 0;return{preset:t,table:e,token:n,label:pm(t.name,e,t.table)}}besideNoControl(){let{preset:t,table:e}=this.scenario;this.session.runBeside({preset:t,table:Om(e),label:"no control"})}swap(){let{now:t,pinned:e}=this.session;!t||!e||(this.session.pin(t),this.scenario.open(e.source.preset,e.source.table))}async save(t){this.status.say(NA[t]),await this.attempt("Not written",async()=>{await Em(t,this.scenario.table),this.status.say("The download is ready.")})}async share(){await this.address.write();try{await navigator.clipboard.writeText(location.href),this.status.say("The link has been copied.")}catch{this.status.say("The link is in the address bar.")}}async follow(t){try{let e=await this.address.read(),n=e&&await this.presetOf(e);e&&(this.view.state=e.view),t(e&&n&&{preset:n,table:e.table})}catch{t(null),this.status.tell("This link is broken; it has not been followed.")}}async presetOf({preset:t,table:e}){return t===this.start.name?this.start:this.schema.scenarios.some(({name:s})=>s===t)?md(t):{name:t,table:e}}async attempt(t,e){try{await e()}catch(n){n instanceof br?this.refused(n.faults,t):this.status.say("The server does not answer.",!0)}}refreshBar(){let{preset:t,dirty:e,canUndo:n,canRedo:s}=this.scenario;document.title=`${t.name}${e?", changed":""} · dampen lab`,this.bar.update({preset:t.name,dirty:e,canUndo:n,canRedo:s,running:this.session.now!==null,pinned:this.pinned})}};var FA=["panels","controls"];function ix(){let i=FA.map(e=>({name:e,tab:Un(`tab-${e}`)})),t=e=>{document.body.dataset.tab=e;for(let{name:n,tab:s}of i)s.setAttribute("aria-selected",String(n===e)),s.tabIndex=n===e?0:-1};for(let{name:e,tab:n}of i)n.addEventListener("click",()=>t(e)),n.addEventListener("keydown",s=>{if(s.key!=="ArrowLeft"&&s.key!=="ArrowRight")return;let r=i.find(o=>o.name!==e);r&&(t(r.name),r.tab.focus())});t("panels")}async function UA(){let i=null,t=new Gl(r=>i?.colours(r));ix();let[e,n]=await Promise.all([Sm(),Mm()]);t.use(e.colours);let s=new Qu(e,n,t);i=s,s.colours(t.dark),lm(r=>{s.open(r)}),addEventListener("hashchange",()=>{s.navigate()}),addEventListener("keydown",r=>{let o=r.target instanceof HTMLInputElement&&r.target.type==="search";!(r.ctrlKey||r.metaKey)||r.key.toLowerCase()!=="z"||o||(r.preventDefault(),r.shiftKey?s.redo():s.undo())}),await s.begin()}UA().catch(i=>{throw Un("status").textContent="The page could not start.",i});
